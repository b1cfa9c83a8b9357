package org.dronemap.core.access;

import org.jspecify.annotations.Nullable;

/** What an access key may be used for; what its owner may not, it never may. */
public enum Permission {
    VIEW,
    /** Missions, fences and rally points: saved ones, and those that drones carry. */
    PLAN,
    /** All other commands, and what operators do with recordings and logs. */
    COMMAND,
    /** What only administrators may. */
    ADMINISTER;

    /** Which one a key must have for what that role may and lesser ones may not; null: none. */
    static @Nullable Permission neededFor(Role role) {
        return switch (role) {
            case REPORTER -> null;
            case VIEWER -> VIEW;
            case PLANNER -> PLAN;
            case OPERATOR, SUPERVISOR -> COMMAND;
            case ADMINISTRATOR -> ADMINISTER;
        };
    }
}
