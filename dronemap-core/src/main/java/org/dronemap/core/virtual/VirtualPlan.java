package org.dronemap.core.virtual;

import org.dronemap.core.mission.Mission;
import org.jspecify.annotations.Nullable;

/**
 * The plan of a virtual drone: what its owner wants flown, by what, and by how many drones.
 *
 * @param needs what each drone must be that serves
 * @param mission null: none yet
 * @param upTo so many drones may share the mission, each flying a part of it
 */
public record VirtualPlan(DroneRequirements needs, @Nullable Mission mission, int upTo) {
    public static final int MOST_DRONES = 8;

    public VirtualPlan {
        if (upTo < 1 || upTo > MOST_DRONES) {
            throw new IllegalArgumentException("a mission is shared by 1 to " + MOST_DRONES + " drones: " + upTo);
        }
    }
}
