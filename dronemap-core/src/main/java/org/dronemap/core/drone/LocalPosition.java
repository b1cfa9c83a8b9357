package org.dronemap.core.drone;

import org.jspecify.annotations.Nullable;

/**
 * Position in the vehicle's own frame, such as a building's map: metres and degrees; null where not reported. What it
 * does not say is null.
 */
public record LocalPosition(
        double xMeters,
        double yMeters,
        @Nullable Double zMeters,
        @Nullable Double yawDegrees) {}
