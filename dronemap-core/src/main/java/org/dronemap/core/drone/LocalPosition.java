package org.dronemap.core.drone;

import org.jspecify.annotations.Nullable;

/** A robot's position in its own frame, such as a building map: metres and degrees. What it does not say is null. */
public record LocalPosition(
        double xMeters,
        double yMeters,
        @Nullable Double zMeters,
        @Nullable Double yawDegrees) {}
