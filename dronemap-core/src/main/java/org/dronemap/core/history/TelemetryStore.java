package org.dronemap.core.history;

import java.time.Instant;
import java.util.List;
import java.util.function.Consumer;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/**
 * Stores telemetry points and history events of drones. Times are kept to the microsecond, places as they are, other
 * numbers to seven digits. Any thread; blocks for the store, and throws when it cannot be reached.
 */
public interface TelemetryStore {
    /** Durable when it returns; points of one drone and moment may be there twice when an earlier try seemed to fail. */
    default void append(List<TelemetryPoint> points, List<HistoryEvent> events) {
        append(points, events, null);
    }

    /**
     * The same; {@code lost}, where there were any, becomes a gap before these events, which are numbered in the order of
     * the list. A lower number never comes to be seen after a higher one.
     */
    void append(List<TelemetryPoint> points, List<HistoryEvent> events, @Nullable EventLoss lost);

    /**
     * Notes that this process stores events from now on. Where another one has not called {@link #closeEvents}, what it
     * had not stored is missing, and a gap says so. Numbers given from now on are at least the microseconds since 1970, so
     * that those which a copy of this store has given are not given again.
     */
    void openEvents(Instant now);

    /** Notes that this process has stored all events. */
    void closeEvents();

    /** Events of all drones and gaps with higher numbers, at most {@code limit} (at least 1). */
    EventPage eventsAfter(long number, int limit);

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
