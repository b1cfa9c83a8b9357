package org.dronemap.ws.access;

import org.dronemap.core.access.Role;
import org.jspecify.annotations.Nullable;

/** Level of access that an operation requires; each level includes the ones before it. */
public enum AccessLevel {
    ANYBODY(null),
    /** Reporters and those with a one-time password included. */
    SIGNED_IN(null),
    VIEWER(Role.VIEWER),
    PLANNER(Role.PLANNER),
    OPERATOR(Role.OPERATOR),
    SUPERVISOR(Role.SUPERVISOR),
    ADMINISTRATOR(Role.ADMINISTRATOR);

    private final @Nullable Role role;

    AccessLevel(@Nullable Role role) {
        this.role = role;
    }

    /** Null: no role is asked for. */
    public @Nullable Role role() {
        return role;
    }
}
