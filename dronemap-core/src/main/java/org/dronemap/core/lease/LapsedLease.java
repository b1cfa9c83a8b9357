package org.dronemap.core.lease;

import java.time.Instant;

/**
 * The record that a user's control of a drone has ended and nobody has taken it since.
 *
 * @param at when that was seen
 * @param sinceNanos the same, monotonic
 * @param returned the drone was told to return already
 */
public record LapsedLease(String user, Instant at, long sinceNanos, boolean returned) {}
