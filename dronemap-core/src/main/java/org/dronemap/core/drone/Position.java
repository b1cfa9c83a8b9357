package org.dronemap.core.drone;

import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/** Position of a vehicle; altitudes in metres above mean sea level and above home, each null if not known. */
public record Position(
        @Nullable Geodetic point,
        @Nullable Double altitudeAmslMeters,
        @Nullable Double altitudeAboveHomeMeters) {}
