package org.dronemap.core.drone;

/** Roll, pitch and yaw in degrees. */
public record Attitude(double rollDegrees, double pitchDegrees, double yawDegrees) {}
