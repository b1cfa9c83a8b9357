package org.dronemap.cognitive.problem;

import org.dronemap.core.stored.Stored;

/**
 * A waypoint of a planning problem: a place that one drone is to visit once, with its task and time window.
 *
 * @param priority what leaving it out weighs, relative to others
 */
@Stored(names = "id place task priority window")
public record Waypoint(String id, Place place, Task task, double priority, TimeWindow window) {
    public static final double LEAST_PRIORITY = 0.001;
    public static final double HIGHEST_PRIORITY = 1_000;

    public Waypoint {
        if (id.isBlank()) {
            throw new IllegalArgumentException("a waypoint must have an id");
        }
        Require.within("priority", priority, LEAST_PRIORITY, HIGHEST_PRIORITY);
    }

    /** To be flown to at any time, with nothing to do there. */
    public static Waypoint at(String id, Place place) {
        return new Waypoint(id, place, Task.FLY_THROUGH, 1, TimeWindow.ALWAYS);
    }
}
