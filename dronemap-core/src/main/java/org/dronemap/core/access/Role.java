package org.dronemap.core.access;

/** What a user may do, least first; each role may do all that the ones before it may. */
public enum Role {
    VIEWER,
    OPERATOR,
    ADMINISTRATOR;

    public boolean includes(Role other) {
        return compareTo(other) >= 0;
    }
}
