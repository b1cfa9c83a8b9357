package org.dronemap.ws.service;

import org.jspecify.annotations.Nullable;

/** Checks names that people give. */
final class Names {
    private Names() {}

    static String checked(String field, @Nullable String value, int longest) {
        String allowed = "1 to " + longest + " characters";
        if (value == null || value.isBlank()) {
            throw InvalidInput.missing(field, allowed);
        }
        String trimmed = value.strip();
        if (trimmed.length() > longest) {
            throw new InvalidInput(
                    field,
                    allowed,
                    "\"" + field + "\" must be " + allowed + "; this one has " + trimmed.length() + ".");
        }
        if (trimmed.chars().anyMatch(Character::isISOControl)) {
            throw new InvalidInput(
                    field, allowed + ", no control characters", "\"" + field + "\" must not have control characters.");
        }
        return trimmed;
    }
}
