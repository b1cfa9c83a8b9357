package org.dronemap.cognitive.problem;

import org.dronemap.core.stored.Stored;

/**
 * The wind of a planning problem, the same everywhere.
 *
 * @param fromDegrees where it comes from, clockwise from north
 */
@Stored(names = "metersPerSecond fromDegrees")
public record UniformWind(double metersPerSecond, double fromDegrees) {
    public static final UniformWind CALM = new UniformWind(0, 0);

    private static final double STRONGEST = 100;

    public UniformWind {
        Require.within("wind metersPerSecond", metersPerSecond, 0, STRONGEST);
        Require.within("wind fromDegrees", fromDegrees, 0, 360);
    }

    /** How fast the air moves east. */
    public double eastMetersPerSecond() {
        return -metersPerSecond * Math.sin(Math.toRadians(fromDegrees));
    }

    public double northMetersPerSecond() {
        return -metersPerSecond * Math.cos(Math.toRadians(fromDegrees));
    }
}
