package org.dronemap.core.history;

import java.time.Duration;
import java.util.List;
import org.dronemap.core.drone.DroneId;

/**
 * Query for a drone's telemetry over time, for drawing: fields, time range and number of slots.
 *
 * @param slots in how many the span is cut; a drawing needs no more than it is wide
 */
public record SeriesQuery(DroneId drone, TimeRange span, List<TelemetryField> fields, int slots) {
    private static final long MICRO = 1_000;

    public SeriesQuery {
        fields = List.copyOf(fields);
        if (slots < 1) {
            throw new IllegalArgumentException("at least one slot is needed, not " + slots);
        }
    }

    /** In whole microseconds, the precision of what is kept; the last slot may reach beyond the span. */
    public Duration slot() {
        long micros = span.length().toNanos() / MICRO;
        return Duration.ofNanos(Math.max(1, (micros + slots - 1) / slots) * MICRO);
    }
}
