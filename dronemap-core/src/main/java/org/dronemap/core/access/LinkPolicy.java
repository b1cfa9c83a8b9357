package org.dronemap.core.access;

/** What the cloud asks of the messages that speak for a drone. */
public enum LinkPolicy {
    /** Nothing is checked and nothing is signed. */
    OFF,
    /** Signed messages must be signed rightly; unsigned ones pass. */
    OPTIONAL,
    /** Only rightly signed messages speak for the drone. */
    REQUIRED
}
