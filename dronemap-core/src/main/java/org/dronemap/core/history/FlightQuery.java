package org.dronemap.core.history;

import java.time.Instant;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/**
 * Search criteria for flights; null matches everything.
 *
 * @param user among those who commanded
 * @param from those that began then or later
 * @param until those that began before
 * @param words in the name of the drone, the notes or the operation, whatever the case
 */
public record FlightQuery(
        @Nullable DroneId drone,
        @Nullable String user,
        @Nullable Instant from,
        @Nullable Instant until,
        @Nullable String words) {
    public static final FlightQuery ALL = new FlightQuery(null, null, null, null, null);
}
