package org.dronemap.core.drone;

import org.jspecify.annotations.Nullable;

/** A vehicle's speeds in m/s (climb positive upwards) and heading in degrees clockwise from true north. */
public record Motion(
        @Nullable Double groundSpeed,
        @Nullable Double airSpeed,
        @Nullable Double climbRate,
        @Nullable Double headingDegrees) {}
