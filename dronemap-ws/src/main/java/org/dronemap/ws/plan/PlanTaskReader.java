package org.dronemap.ws.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.dronemap.core.mission.WaypointTask;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.RecordAlternatives;
import org.jspecify.annotations.Nullable;

/** Turns tasks that a client wants done at a waypoint of a plan into the planner's, or rejects the faulty field. */
final class PlanTaskReader {
    static final int MOST = 10;
    private static final String COUNT = "up to " + MOST + " tasks";
    private static final String TYPES =
            RecordAlternatives.of(PlanTaskRequest.class).orElseThrow().allowed();

    private final ToDoubleFunction<@Nullable Double> amslMeters;

    /** {@code amslMeters}: what an altitude as written means above the sea. */
    PlanTaskReader(ToDoubleFunction<@Nullable Double> amslMeters) {
        this.amslMeters = amslMeters;
    }

    List<WaypointTask> read(String at, @Nullable List<@Nullable PlanTaskRequest> asked) {
        if (asked == null) {
            return List.of();
        }
        if (asked.size() > MOST) {
            throw InvalidInput.outside(
                    ValueProblem.SIZE_OUT_OF_RANGE, at, COUNT, asked.size(), ProblemParameter.MOST.is(MOST));
        }
        List<WaypointTask> tasks = new ArrayList<>();
        for (int index = 0; index < asked.size(); index++) {
            tasks.add(task(at + "[" + index + "]", asked.get(index)));
        }
        return tasks;
    }

    private WaypointTask task(String at, @Nullable PlanTaskRequest asked) {
        if (asked == null) {
            throw InvalidInput.missing(at + ".type", TYPES);
        }
        return asked.read(at + ".", amslMeters);
    }
}
