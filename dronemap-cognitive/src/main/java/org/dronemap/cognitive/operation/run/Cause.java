package org.dronemap.cognitive.operation.run;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * A cause for replanning, with the drone concerned and the waypoints that it leaves.
 *
 * @param words a sentence
 * @param orphans the waypoints that the drone had until then
 */
@Stored(names = "trigger drone words orphans")
public record Cause(Trigger trigger, @Nullable DroneId drone, String words, List<String> orphans) {
    /** Nothing has to be changed: a better plan is looked for than the one at once. */
    static final Cause BETTER = new Cause(Trigger.BETTER_PLAN, null, "A better plan was looked for.", List.of());

    private static final Set<Trigger> PATIENT = EnumSet.of(
            Trigger.JOINED,
            Trigger.RESUMED,
            Trigger.HEARD_AGAIN,
            Trigger.WAYPOINT_CANCELLED,
            Trigger.LATE,
            Trigger.OFF_PATH,
            Trigger.ANSWERED,
            Trigger.BETTER_PLAN);

    public Cause {
        orphans = List.copyOf(orphans);
    }

    boolean isBetter() {
        return trigger == Trigger.BETTER_PLAN;
    }

    /** A plan that is searched for is worth waiting for. */
    boolean isPatient() {
        return PATIENT.contains(trigger);
    }
}
