package org.dronemap.core.lease;

import java.time.Instant;

/**
 * A time read from both clocks: time of day and monotonic nanoseconds; input of the lease machine.
 *
 * @param at for people
 * @param nanos monotonic, for durations
 */
public record ClockReading(Instant at, long nanos) {}
