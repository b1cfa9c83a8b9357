package org.dronemap.core.history;

import java.time.Instant;
import java.util.List;
import java.util.function.Consumer;
import org.dronemap.core.drone.DroneId;

/**
 * Stores telemetry points and history events of drones. Times are kept to the microsecond, places as they are, other
 * numbers to seven digits. Any thread; blocks for the store, and throws when it cannot be reached.
 */
public interface TelemetryStore {
    /** Durable when it returns; points of one drone and moment may be there twice when an earlier try seemed to fail. */
    void append(List<TelemetryPoint> points, List<HistoryEvent> events);

    /** All points of a drone in the order of time, each moment once; {@code each} must not ask this store anything. */
    void points(DroneId drone, TimeRange span, Consumer<TelemetryPoint> each);

    /** In the order of time. */
    List<SeriesSlot> series(SeriesQuery query);

    /** Oldest first, at most {@code limit}. */
    List<HistoryEvent> events(DroneId drone, TimeRange span, int limit);

    /** Makes room for the days to come, thins old days and drops older ones; what it cannot do now it does next time. */
    void tidy(Retention retention, Instant now);

    /** What it is and in which version, for people. */
    String server();
}
