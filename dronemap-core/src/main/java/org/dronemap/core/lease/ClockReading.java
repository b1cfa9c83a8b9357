package org.dronemap.core.lease;

import java.time.Instant;

/**
 * A point in time.
 *
 * @param at for people
 * @param nanos monotonic, for durations
 */
public record ClockReading(Instant at, long nanos) {}
