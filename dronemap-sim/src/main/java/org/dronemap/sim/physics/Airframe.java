package org.dronemap.sim.physics;

/** The performance limits of a simulated airframe, in m/s, m/s², rad and rad/s. */
public record Airframe(
        double horizontalAcceleration,
        double horizontalDeceleration,
        double verticalAcceleration,
        double yawRate,
        double maxLean,
        double drag,
        double terminalSpeed,
        double asksToLean) {

    /** A quadcopter of about two kilograms; falls at the 11.8 m/s seen with one motor dead. */
    public static Airframe quadcopter() {
        return new Airframe(
                2.5, 1.3, 1.0, Math.toRadians(60), Math.toRadians(35), 0.25, 11.8, Double.POSITIVE_INFINITY);
    }

    /** The same that leans no farther than that: 30 degrees as ArduCopter is delivered (ANGLE_MAX). */
    public static Airframe leaning(double degrees) {
        return new Airframe(2.5, 1.3, 1.0, Math.toRadians(60), Math.toRadians(35), 0.25, 11.8, Math.toRadians(degrees));
    }

    /** The lift motors of an aeroplane, whose propeller at the nose makes it gather speed quicker than they could. */
    public static Airframe lifted() {
        return new Airframe(
                3.5, 1.3, 1.0, Math.toRadians(60), Math.toRadians(35), 0.25, 11.8, Double.POSITIVE_INFINITY);
    }

    boolean isNeverAtItsEnd() {
        return Double.isInfinite(asksToLean);
    }

    /** What the air takes of its leaning, in m/s² for each m/s of airspeed; 11.5 m/s are the most at 30 degrees, as of a real ArduCopter. */
    double resistance(double airspeed) {
        return 0.15 + 0.0295 * airspeed;
    }
}
