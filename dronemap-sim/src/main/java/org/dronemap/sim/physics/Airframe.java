package org.dronemap.sim.physics;

/**
 * What an airframe can do: accelerations in m/s² (the deceleration is the planned one), rates in rad/s, drag as the acceleration per m/s of airspeed,
 * terminal speed of a fall in m/s.
 */
public record Airframe(
        double horizontalAcceleration,
        double horizontalDeceleration,
        double verticalAcceleration,
        double yawRate,
        double maxLean,
        double drag,
        double terminalSpeed) {

    /** A quadcopter of about two kilograms; falls at the 11.8 m/s seen with one motor dead. */
    public static Airframe quadcopter() {
        return new Airframe(2.5, 1.3, 1.0, Math.toRadians(60), Math.toRadians(35), 0.25, 11.8);
    }
}
