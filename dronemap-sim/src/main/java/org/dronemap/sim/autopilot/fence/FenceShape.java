package org.dronemap.sim.autopilot.fence;

import java.util.List;
import org.dronemap.sim.physics.NeuPosition;

/** One area of a fence, in the local frame of its vehicle; metres. */
sealed interface FenceShape {
    /** True when a vehicle has to stay inside, false when it has to stay outside. */
    boolean inclusion();

    boolean contains(NeuPosition place);

    default boolean allows(NeuPosition place) {
        return contains(place) == inclusion();
    }

    record Circle(boolean inclusion, NeuPosition center, double radius) implements FenceShape {
        @Override
        public boolean contains(NeuPosition place) {
            return place.horizontalDistanceTo(center) < radius;
        }
    }

    record Polygon(boolean inclusion, List<NeuPosition> corners) implements FenceShape {
        @Override
        public boolean contains(NeuPosition place) {
            boolean inside = false;
            NeuPosition from = corners.get(corners.size() - 1);
            for (NeuPosition to : corners) {
                boolean crosses = (from.east() > place.east()) != (to.east() > place.east());
                double share = (place.east() - from.east()) / (to.east() - from.east());
                if (crosses && place.north() < from.north() + share * (to.north() - from.north())) {
                    inside = !inside;
                }
                from = to;
            }
            return inside;
        }
    }
}
