package org.dronemap.cognitive.operation.run.model;

import java.time.Instant;
import java.util.List;
import org.dronemap.cognitive.replan.PlanFigures;
import org.dronemap.cognitive.replan.ReassignedWaypoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * A decision of a mission run explained to users: its trigger, waypoints that changed drones, and the plan's figures.
 *
 * @param number from 1
 * @param drone whom it began with; null: nobody in particular
 * @param moved which waypoint is another drone's now
 * @param before what the plan came to, the waypoints without a drone left out; null: nothing was planned anew
 * @param words one or more sentences
 */
@Stored(names = "number at trigger drone moved before after words")
public record RunExplanation(
        int number,
        Instant at,
        RunTrigger trigger,
        @Nullable DroneId drone,
        List<ReassignedWaypoint> moved,
        @Nullable PlanFigures before,
        @Nullable PlanFigures after,
        String words) {
    public RunExplanation {
        moved = List.copyOf(moved);
    }
}
