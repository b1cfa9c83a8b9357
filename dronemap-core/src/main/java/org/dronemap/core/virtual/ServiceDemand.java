package org.dronemap.core.virtual;

import org.dronemap.core.drone.Wind;
import org.jspecify.annotations.Nullable;

/**
 * Demand of a virtual drone or a follow on the drone that serves it: requirements, tour, first waypoint and wind.
 *
 * @param first the tour's waypoint to begin with, counted from 0
 * @param wind there; null: not known
 */
public record ServiceDemand(
        DroneRequirements needs,
        VirtualTour tour,
        int first,
        @Nullable Wind wind) {
    public ServiceDemand(DroneRequirements needs, VirtualTour tour, int first) {
        this(needs, tour, first, null);
    }
}
