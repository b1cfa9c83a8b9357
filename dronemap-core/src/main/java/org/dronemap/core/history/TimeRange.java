package org.dronemap.core.history;

import java.time.Duration;
import java.time.Instant;

/** A half-open time range: includes from, excludes until. */
public record TimeRange(Instant from, Instant until) {
    public TimeRange {
        if (until.isBefore(from)) {
            throw new IllegalArgumentException("it ends before it begins: " + from + " to " + until);
        }
    }

    public Duration length() {
        return Duration.between(from, until);
    }

    public boolean contains(Instant at) {
        return !at.isBefore(from) && at.isBefore(until);
    }
}
