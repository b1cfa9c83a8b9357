package org.dronemap.core.mission;

import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.stored.Stored;

/** An area, polygon or circle, to stay in or out of: in a vehicle's own fence, or as the shape of a zone. */
public sealed interface FenceArea {
    boolean inside();

    /** An area with 3 to 1000 corners: outlines of real airspaces have up to 650. */
    @Stored(as = "Polygon", names = "inside corners")
    record Polygon(boolean inside, List<Geodetic> corners) implements FenceArea {
        public static final int LEAST_CORNERS = 3;
        public static final int MOST_CORNERS = 1_000;

        public Polygon {
            corners = List.copyOf(corners);
            if (corners.size() < LEAST_CORNERS || corners.size() > MOST_CORNERS) {
                throw new IllegalArgumentException("an area of a fence has 3 to 1000 corners, not " + corners.size());
            }
        }
    }

    /** A circle with a radius of 0.01 to 100,000 m. */
    @Stored(as = "Circle", names = "inside center radiusMeters")
    record Circle(boolean inside, Geodetic center, double radiusMeters) implements FenceArea {
        public static final double LEAST_RADIUS_METERS = 0.01;
        public static final double MOST_RADIUS_METERS = 100_000;

        public Circle {
            if (!(radiusMeters >= LEAST_RADIUS_METERS && radiusMeters <= MOST_RADIUS_METERS)) {
                throw new IllegalArgumentException(
                        "a circle of a fence has a radius of 0.01 to 100000 m: " + radiusMeters);
            }
        }
    }
}
