package org.dronemap.core.lease;

/**
 * A holder fell silent and nobody has taken control since.
 *
 * @param sinceNanos monotonic
 * @param returned the drone was told to return already
 */
public record Lapse(String user, long sinceNanos, boolean returned) {}
