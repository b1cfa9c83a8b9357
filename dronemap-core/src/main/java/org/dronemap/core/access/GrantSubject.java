package org.dronemap.core.access;

/** The user or group that a grant is for. */
public sealed interface GrantSubject {
    /** One user, by name. */
    record OfUser(String name) implements GrantSubject {}

    /** Whoever is in the group at the time, by the group's id. */
    record OfGroup(String id) implements GrantSubject {}
}
