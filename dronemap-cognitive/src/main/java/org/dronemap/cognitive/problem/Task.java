package org.dronemap.cognitive.problem;

import java.util.List;
import java.util.Set;
import org.dronemap.core.mission.WaypointTask;
import org.dronemap.core.stored.Stored;

/**
 * The task at a waypoint: how long it takes, the skills it needs, and its parts in order.
 *
 * @param serviceSeconds how long a drone stays for all of it
 * @param needs what it must be able to do
 * @param parts what is done there, in order
 */
@Stored(names = "serviceSeconds needs parts")
public record Task(double serviceSeconds, Set<Skill> needs, List<WaypointTask> parts) {
    public static final Task FLY_THROUGH = new Task(0, Set.of());

    private static final double LONGEST_SECONDS = 86_400;

    public Task {
        Require.within("serviceSeconds", serviceSeconds, 0, LONGEST_SECONDS);
        needs = Set.copyOf(needs);
        parts = List.copyOf(parts);
        double least = parts.stream().mapToDouble(WaypointTask::seconds).sum();
        if (serviceSeconds < least) {
            throw new IllegalArgumentException("its parts take " + least + " s, and it has " + serviceSeconds);
        }
    }

    /** With nothing to do there but to stay. */
    public Task(double serviceSeconds, Set<Skill> needs) {
        this(serviceSeconds, needs, List.of());
    }
}
