package org.dronemap.core.access;

/** The share of what a drone did at some time that is shown to somebody. */
public enum VisibilityLevel {
    /** As if it had not been. */
    NONE,
    /** What it did, and no names of people: it belonged to others then. */
    WITHOUT_NAMES,
    ALL
}
