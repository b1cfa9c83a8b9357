package org.dronemap.core.access;

import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/** Roles of users in rising order; each one includes the roles before it. */
@Stored(names = "REPORTER VIEWER PLANNER OPERATOR SUPERVISOR ADMINISTRATOR")
public enum Role {
    /** Of the public: sends reports, sees no drone. */
    REPORTER,
    /** Watches. */
    VIEWER,
    /** Prepares missions, fences and rally points, and puts them on drones; flies nothing. */
    PLANNER,
    /** Commands drones. */
    OPERATOR,
    /** Answers for safety: may stop, land and call back what others fly. */
    SUPERVISOR,
    /** Manages users, links and the server. */
    ADMINISTRATOR;

    /** Which one a key or a grant must hold for what this role may and lesser ones may not; null: none. */
    public @Nullable Permission permission() {
        return switch (this) {
            case REPORTER -> null;
            case VIEWER -> Permission.VIEW;
            case PLANNER -> Permission.PLAN;
            case OPERATOR, SUPERVISOR -> Permission.COMMAND;
            case ADMINISTRATOR -> Permission.ADMINISTER;
        };
    }

    public boolean includes(Role other) {
        return compareTo(other) >= 0;
    }
}
