package org.dronemap.core.drone;

import java.util.List;
import org.dronemap.core.mission.RallyPoint;

/**
 * The rally points as they were read from a vehicle.
 *
 * @param leftOut what the vehicle has and cannot be told here, each as a sentence
 */
public record OnboardRallyPoints(List<RallyPoint> points, List<String> leftOut) {
    public OnboardRallyPoints {
        points = List.copyOf(points);
        leftOut = List.copyOf(leftOut);
    }

    /** All of them. */
    public static OnboardRallyPoints of(List<RallyPoint> points) {
        return new OnboardRallyPoints(points, List.of());
    }
}
