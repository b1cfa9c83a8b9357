package org.dronemap.core.mission;

import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.stored.Stored;

/** An area, polygon or circle, to stay in or out of: in a vehicle's own fence, or as the shape of a zone. */
public sealed interface FenceArea {
    boolean inside();

    /** An area with 3 to 100 corners. */
    @Stored(as = "Polygon", names = "inside corners")
    record Polygon(boolean inside, List<Geodetic> corners) implements FenceArea {
        public Polygon {
            corners = List.copyOf(corners);
            if (corners.size() < 3 || corners.size() > 100) {
                throw new IllegalArgumentException("an area of a fence has 3 to 100 corners, not " + corners.size());
            }
        }
    }

    /** A circle with a radius of 1 to 100,000 m. */
    @Stored(as = "Circle", names = "inside center radiusMeters")
    record Circle(boolean inside, Geodetic center, double radiusMeters) implements FenceArea {
        public Circle {
            if (!(radiusMeters >= 1 && radiusMeters <= 100_000)) {
                throw new IllegalArgumentException(
                        "a circle of a fence has a radius of 1 to 100000 m: " + radiusMeters);
            }
        }
    }
}
