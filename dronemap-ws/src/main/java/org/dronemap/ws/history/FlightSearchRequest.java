package org.dronemap.ws.history;

import org.dronemap.core.drone.DroneId;
import org.dronemap.core.history.FlightQuery;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.WireTimes;
import org.jspecify.annotations.Nullable;

/**
 * Query parameters of a search for flights, and of the logbook's export; a null or empty one matches all.
 *
 * @param user among those who commanded
 * @param from those that began then or later
 * @param until those that began before
 * @param words in the name of the drone, the notes or what conducted it
 */
public record FlightSearchRequest(
        @Nullable String drone,
        @Nullable String user,
        @Nullable String from,
        @Nullable String until,
        @Nullable String words) {
    FlightQuery query() {
        return new FlightQuery(
                drone(given(drone)),
                given(user),
                WireTimes.read("from", from),
                WireTimes.read("until", until),
                given(words));
    }

    private static @Nullable DroneId drone(@Nullable String id) {
        if (id == null) {
            return null;
        }
        try {
            return new DroneId(id);
        } catch (IllegalArgumentException notAnId) {
            throw InvalidInput.outside(ValueProblem.VALUE_MALFORMED, "drone", "the id of a drone", "\"" + id + "\"");
        }
    }

    private static @Nullable String given(@Nullable String text) {
        return text == null || text.isBlank() ? null : text.strip();
    }
}
