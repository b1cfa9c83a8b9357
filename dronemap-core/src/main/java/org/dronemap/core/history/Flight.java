package org.dronemap.core.history;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * A flight in the history: from arming to disarming, or until contact was lost.
 *
 * @param droneName as it was called when the flight began
 * @param end null while it goes on; of one that was lost, when it was last heard
 * @param lastHeardAt when it was last looked at
 * @param users who commanded it, in the order of their first command; empty: nobody here
 * @param operation what the cloud conducted with it; null: nothing
 * @param notice what a reader has to know, a sentence; null: nothing
 * @param notes of people, empty at first
 */
public record Flight(
        String id,
        DroneId drone,
        String droneName,
        Instant start,
        @Nullable Instant end,
        State state,
        Instant lastHeardAt,
        FlightStatistics measures,
        List<String> users,
        @Nullable FlightOperation operation,
        @Nullable String notice,
        String notes) {
    private static final int MOST_USERS = 20;

    /** State of a flight: running, contact lost or ended. */
    @Stored(names = "RUNNING LOST ENDED")
    public enum State {
        RUNNING,
        /** There is no contact; it may still fly, and go on when it is heard again. */
        LOST,
        ENDED
    }

    /**
     * Operation that conducted a flight: its id and its name for people, such as: The virtual drone “Survey” of ann.
     */
    public record FlightOperation(String id, String words) {}

    public Flight {
        users = List.copyOf(users);
    }

    Flight with(FlightStatistics now, Instant at) {
        return new Flight(id, drone, droneName, start, end, state, at, now, users, operation, notice, notes);
    }

    Flight in(State next, @Nullable Instant ended, @Nullable String why) {
        return new Flight(
                id, drone, droneName, start, ended, next, lastHeardAt, measures, users, operation, why, notes);
    }

    Flight by(@Nullable String user) {
        if (user == null || users.contains(user) || users.size() == MOST_USERS) {
            return this;
        }
        List<String> all = new ArrayList<>(users);
        all.add(user);
        return new Flight(
                id, drone, droneName, start, end, state, lastHeardAt, measures, all, operation, notice, notes);
    }

    Flight conductedBy(FlightOperation conductor) {
        return new Flight(
                id, drone, droneName, start, end, state, lastHeardAt, measures, users, conductor, notice, notes);
    }
}
