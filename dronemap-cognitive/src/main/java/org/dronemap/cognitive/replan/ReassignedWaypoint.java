package org.dronemap.cognitive.replan;

import org.dronemap.core.drone.DroneId;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * A waypoint that a re-planning gave to another drone than before.
 *
 * @param from nobody, when it is new or was unserved
 * @param to nobody, when it is unserved now
 */
@Stored(names = "waypoint from to")
public record ReassignedWaypoint(
        String waypoint, @Nullable DroneId from, @Nullable DroneId to) {}
