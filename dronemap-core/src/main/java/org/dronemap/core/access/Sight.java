package org.dronemap.core.access;

/** How much of what a drone did at some time is shown to somebody. */
public enum Sight {
    /** As if it had not been. */
    NONE,
    /** What it did, and no names of people: it belonged to others then. */
    WITHOUT_NAMES,
    ALL
}
