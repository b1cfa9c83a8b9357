package org.dronemap.core.drone;

import java.util.List;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.mission.FenceReturnPoint;
import org.jspecify.annotations.Nullable;

/**
 * The fence as it was read from a vehicle.
 *
 * @param leftOut what the vehicle has and cannot be told here, each as a sentence
 */
public record OnboardFence(List<FenceArea> areas, @Nullable FenceReturnPoint returnPoint, List<String> leftOut) {
    public OnboardFence {
        areas = List.copyOf(areas);
        leftOut = List.copyOf(leftOut);
    }

    /** Whole, without a return point. */
    public static OnboardFence of(List<FenceArea> areas) {
        return new OnboardFence(areas, null, List.of());
    }
}
