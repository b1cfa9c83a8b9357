package org.dronemap.core.access;

/** Share of a drone's activity at some time that a user may see: nothing, all, or all but names of people. */
public enum VisibilityLevel {
    /** As if it had not been. */
    NONE,
    /** What it did, and no names of people: it belonged to others then. */
    WITHOUT_NAMES,
    ALL
}
