package org.dronemap.cognitive.operation.run.model;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * A cause for re-planning a mission run, with the drone concerned and the waypoints that it leaves.
 *
 * @param words a sentence
 * @param orphans the waypoints that the drone had until then
 */
@Stored(names = "trigger drone words orphans")
public record ReplanCause(RunTrigger trigger, @Nullable DroneId drone, String words, List<String> orphans) {
    /** Nothing has to be changed: a better plan is looked for than the one at once. */
    public static final ReplanCause BETTER =
            new ReplanCause(RunTrigger.BETTER_PLAN, null, "A better plan was looked for.", List.of());

    private static final Set<RunTrigger> PATIENT = EnumSet.of(
            RunTrigger.JOINED,
            RunTrigger.RESUMED,
            RunTrigger.HEARD_AGAIN,
            RunTrigger.WAYPOINT_CANCELLED,
            RunTrigger.LATE,
            RunTrigger.OFF_PATH,
            RunTrigger.ANSWERED,
            RunTrigger.BETTER_PLAN);

    public ReplanCause {
        orphans = List.copyOf(orphans);
    }

    public boolean isBetter() {
        return trigger == RunTrigger.BETTER_PLAN;
    }

    /** A plan that is searched for is worth waiting for. */
    public boolean isPatient() {
        return PATIENT.contains(trigger);
    }
}
