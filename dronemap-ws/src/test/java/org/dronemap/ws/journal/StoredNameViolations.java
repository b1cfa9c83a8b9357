package org.dronemap.ws.journal;

import org.dronemap.core.access.Role;

/** Takes what it writes and reads from the names of the code. */
public final class StoredNameViolations {
    public String simple(Object value) {
        return value.getClass().getSimpleName();
    }

    public String constant(Role role) {
        return role.name();
    }

    public Role read(String text) {
        return Role.valueOf(text);
    }

    public String component(Class<?> type) {
        return type.getRecordComponents()[0].getName();
    }
}
