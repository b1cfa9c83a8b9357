package org.dronemap.cognitive.plan;

import org.dronemap.core.stored.Stored;

/**
 * A stop of a planned tour: the visit to one waypoint, with the leg to it, its times and the energy used.
 *
 * @param way how the drone comes there
 * @param beginsSeconds when its task begins: at the arrival, or when its window opens
 * @param leavesSeconds when the drone is free to leave; the next way may begin later
 * @param usedJoules drawn since the plan's beginning, when it leaves
 */
@Stored(names = "waypoint way beginsSeconds leavesSeconds usedJoules")
public record TourStop(String waypoint, TourLeg way, double beginsSeconds, double leavesSeconds, double usedJoules) {
    public double arrivesSeconds() {
        return way.arrivesSeconds();
    }
}
