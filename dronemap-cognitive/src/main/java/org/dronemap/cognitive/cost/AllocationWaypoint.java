package org.dronemap.cognitive.cost;

import java.util.BitSet;

/**
 * One waypoint as the search sees it: service, priority, time window and the drones that can serve it.
 *
 * @param serviceSeconds how long a drone stays for its task
 * @param serviceWatts what it draws meanwhile, and while it waits for the window to open
 * @param priority what leaving it out weighs, above 0, relative to others
 * @param opensSeconds service begins no earlier, on the plan's clock
 * @param closesSeconds service begins no later; infinite without a window
 * @param drones those that can serve it
 */
public record AllocationWaypoint(
        double serviceSeconds,
        double serviceWatts,
        double priority,
        double opensSeconds,
        double closesSeconds,
        BitSet drones) {
    public AllocationWaypoint {
        drones = (BitSet) drones.clone();
    }

    @Override
    public BitSet drones() {
        return (BitSet) drones.clone();
    }
}
