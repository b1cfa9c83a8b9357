package org.dronemap.ws.reading;

import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;

/** Checks names, labels and reasons that users write: neither empty nor too long, no control characters. */
public final class NameRules {
    private NameRules() {}

    public static String checked(String field, @Nullable String value, int longest) {
        String allowed = "1 to " + longest + " characters";
        if (value == null || value.isBlank()) {
            throw InvalidInput.missing(field, allowed);
        }
        String trimmed = value.strip();
        if (trimmed.length() > longest) {
            throw new InvalidInput(
                    ValueProblem.SIZE_OUT_OF_RANGE,
                    field,
                    allowed,
                    "\"" + field + "\" must be " + allowed + "; this one has " + trimmed.length() + ".",
                    ProblemParameter.LEAST.is(1),
                    ProblemParameter.MOST.is(longest));
        }
        if (trimmed.chars().anyMatch(Character::isISOControl)) {
            throw new InvalidInput(
                    ValueProblem.VALUE_MALFORMED,
                    field,
                    allowed + ", no control characters",
                    "\"" + field + "\" must not have control characters.");
        }
        return trimmed;
    }
}
