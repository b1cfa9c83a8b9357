package org.dronemap.core.access;

/** What a user may do, least first; each role may do all that the ones before it may. */
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

    public boolean includes(Role other) {
        return compareTo(other) >= 0;
    }
}
