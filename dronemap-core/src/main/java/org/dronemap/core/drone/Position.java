package org.dronemap.core.drone;

import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/** Where a vehicle is; altitudes in metres above mean sea level and above its home, each unknown on its own. */
public record Position(
        @Nullable Geodetic point,
        @Nullable Double altitudeAmslMeters,
        @Nullable Double altitudeAboveHomeMeters) {}
