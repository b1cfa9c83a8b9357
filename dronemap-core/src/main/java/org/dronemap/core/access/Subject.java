package org.dronemap.core.access;

/** The user or group that a grant is for. */
public sealed interface Subject {
    /** One user, by name. */
    record OfUser(String name) implements Subject {}

    /** Whoever is in the group at the time, by the group's id. */
    record OfGroup(String id) implements Subject {}
}
