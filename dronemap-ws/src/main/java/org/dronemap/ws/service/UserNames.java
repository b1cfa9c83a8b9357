package org.dronemap.ws.service;

import org.jspecify.annotations.Nullable;

/** What a user name must be. */
final class UserNames {
    private static final String FORM = "1 to 40 of letters, digits, '.', '_', '-' and '@'";

    private UserNames() {}

    static String checked(@Nullable String name) {
        if (name == null) {
            throw InvalidInput.missing("name", FORM);
        }
        if (!name.matches("[\\p{L}\\p{N}._@-]{1,40}")) {
            throw InvalidInput.outside("name", FORM, "\"" + name + "\"");
        }
        return name;
    }
}
