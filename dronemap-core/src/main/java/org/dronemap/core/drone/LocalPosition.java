package org.dronemap.core.drone;

import org.jspecify.annotations.Nullable;

/**
 * Where a vehicle is in a frame of its own, such as the map of a building, whose place on the Earth nobody knows: metres
 * along x and y, upwards along z, degrees counter-clockwise from x. What it does not say is null.
 */
public record LocalPosition(
        double xMeters,
        double yMeters,
        @Nullable Double zMeters,
        @Nullable Double yawDegrees) {}
