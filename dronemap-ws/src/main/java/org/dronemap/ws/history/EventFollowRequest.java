package org.dronemap.ws.history;

import io.swagger.v3.oas.annotations.Parameter;
import java.time.Duration;
import java.util.Arrays;
import java.util.Set;
import java.util.stream.Collectors;
import org.dronemap.core.drone.DroneId;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;

/**
 * Query parameters that choose which events a client follows; a null or empty one: the default.
 *
 * @param drones ids with commas between them
 */
record EventFollowRequest(
        @Parameter(
                description = "The next of an earlier answer; first: from the oldest event that is kept; none: from now"
                        + " on, with an answer at once that has no events")
        @Nullable
        String after,

        @Parameter(description = "Events and gaps at most, 1 to 1000; 100 unless said otherwise") @Nullable
        Integer limit,

        @Parameter(description = "Ids of drones with commas between them, at most 200; all unless said otherwise")
        @Nullable
        String drones) {
    static final String FIRST = "first";
    private static final int USUAL_LIMIT = 100;
    private static final int GREATEST_LIMIT = 1_000;
    private static final int LONGEST_WAIT_SECONDS = 60;
    private static final int MOST_DRONES = 200;

    /** Null: from now on. */
    @Nullable
    String place() {
        return after == null || after.isBlank() ? null : after.strip();
    }

    int most() {
        int most = limit == null ? USUAL_LIMIT : limit;
        if (most < 1 || most > GREATEST_LIMIT) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_OUT_OF_RANGE,
                    "limit",
                    "1 to " + GREATEST_LIMIT,
                    most,
                    ProblemParameter.LEAST.is(1),
                    ProblemParameter.MOST.is(GREATEST_LIMIT));
        }
        return most;
    }

    /** How long it waits for them, of the parameter of its own that cannot have its name in a record. */
    static Duration longest(@Nullable Double wait) {
        double seconds = wait == null ? 0 : wait;
        if (!(seconds >= 0 && seconds <= LONGEST_WAIT_SECONDS)) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_OUT_OF_RANGE,
                    "wait",
                    "0 to " + LONGEST_WAIT_SECONDS + " seconds",
                    seconds,
                    ProblemParameter.LEAST.is(0),
                    ProblemParameter.MOST.is(LONGEST_WAIT_SECONDS),
                    ProblemParameter.UNIT.is("seconds"));
        }
        return Duration.ofMillis(Math.round(seconds * 1000));
    }

    /** Null: all. */
    @Nullable
    Set<DroneId> chosen() {
        if (drones == null || drones.isBlank()) {
            return null;
        }
        String[] ids = drones.split(",", -1);
        if (ids.length > MOST_DRONES) {
            throw InvalidInput.outside(
                    ValueProblem.SIZE_OUT_OF_RANGE,
                    "drones",
                    "at most " + MOST_DRONES + " ids",
                    ids.length,
                    ProblemParameter.MOST.is(MOST_DRONES));
        }
        return Arrays.stream(ids).map(EventFollowRequest::id).collect(Collectors.toUnmodifiableSet());
    }

    private static DroneId id(String text) {
        try {
            return new DroneId(text.strip());
        } catch (IllegalArgumentException notAnId) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_MALFORMED,
                    "drones",
                    "ids of drones with commas between them",
                    "\"" + text.strip() + "\"");
        }
    }
}
