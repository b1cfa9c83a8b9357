package org.dronemap.core.separation;

/**
 * Speed profile of a straight leg that ends at rest: how far along it a drone is at each time. Speeds in m/s,
 * metres, seconds.
 */
final class MotionProfile {
    private final double meters;
    private final double begins;
    private final double peak;
    private final double acceleration;
    private final double untilPeak;
    private final double atPeak;
    private final double braking;

    /** {@code moving}: how fast it is at its beginning. */
    MotionProfile(double meters, double moving, FlightPace speeds) {
        this.meters = meters;
        this.acceleration = speeds.acceleration();
        this.begins = Math.min(moving, speeds.cruise());
        double most = meters == 0 ? 0 : Math.sqrt(acceleration * meters + begins * begins / 2);
        // Too near to stop in time: it brakes as hard as that takes.
        this.peak = Math.min(speeds.cruise(), Math.max(begins, most));
        double gathering = (peak * peak - begins * begins) / (2 * acceleration);
        double stopping = Math.min(meters, peak * peak / (2 * acceleration));
        this.untilPeak = (peak - begins) / acceleration;
        this.atPeak = peak == 0 ? 0 : Math.max(0, meters - gathering - stopping) / peak;
        this.braking = peak == 0 ? 0 : 2 * stopping / peak;
    }

    double seconds() {
        return untilPeak + atPeak + braking;
    }

    /** Of the way, from 0 to 1. */
    double share(double seconds) {
        if (meters == 0 || seconds >= seconds()) {
            return 1;
        }
        double left = seconds() - seconds;
        if (left < braking) {
            return 1 - (peak / braking) * left * left / 2 / meters;
        }
        double gathered = Math.min(seconds, untilPeak);
        double gained = untilPeak == 0 ? 0 : acceleration * gathered * gathered / 2;
        return (begins * gathered + gained + peak * Math.max(0, seconds - untilPeak)) / meters;
    }
}
