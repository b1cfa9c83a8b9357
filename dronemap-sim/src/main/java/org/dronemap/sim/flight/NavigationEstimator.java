package org.dronemap.sim.flight;

/**
 * The GPS receiver and position estimate of a simulated vehicle: when they are ready, and when they fail. Owned by its
 * vehicle.
 */
public final class NavigationEstimator {
    /** How long the estimate is trusted without GPS, as seen on a real autopilot. */
    public static final long LOSS_MILLIS = 8_000;

    private static final long REGAIN_MILLIS = 1_200;
    /** When the steps of starting up are done, as shares of the time until the estimate stands; seen on a real autopilot. */
    private static final double FIX_SHARE = 0.21;

    private static final double ACTIVE_SHARE = 0.08;
    private static final double STARTED_SHARE = 0.1;
    private static final double TILT_SHARE = 0.123;
    private static final double ACCELEROMETERS_SHARE = 0.3;
    private static final double ORIGIN_SHARE = 0.465;
    private static final double GYROS_SHARE = 0.55;

    private final long readyAfterMillis;
    private boolean receiving = true;
    private long lostSince;
    private long regainedSince;
    private long backAt = Long.MAX_VALUE;
    private boolean estimate;
    private boolean hadEstimate;
    private long startedAt;
    private long now;

    public NavigationEstimator(long readyAfterMillis) {
        this.readyAfterMillis = readyAfterMillis;
    }

    public void step(long nowMillis) {
        now = nowMillis;
        if (!receiving && nowMillis >= backAt) {
            setReceiving(true);
        }
        if (!receiving) {
            estimate = estimate && nowMillis - lostSince < LOSS_MILLIS;
        } else if (!estimate && nowMillis - startedAt >= readyAfterMillis) {
            estimate = regainedSince == 0 || nowMillis - regainedSince >= REGAIN_MILLIS;
        }
        hadEstimate |= estimate;
    }

    /** Power comes back: everything has to be found again. */
    public void restart() {
        startedAt = now;
        estimate = false;
        hadEstimate = false;
        regainedSince = 0;
    }

    /** Without a signal for so long. */
    public void lose(long millis) {
        setReceiving(false);
        backAt = now + millis;
    }

    public void setReceiving(boolean on) {
        backAt = Long.MAX_VALUE;
        if (on && !receiving) {
            regainedSince = now;
        } else if (!on && receiving) {
            lostSince = now;
        }
        receiving = on;
    }

    public boolean hasFix() {
        return receiving && started(FIX_SHARE);
    }

    /** It has begun to estimate its attitude. */
    public boolean started() {
        return started(STARTED_SHARE);
    }

    /** It knows its attitude and its heading. */
    public boolean tiltAligned() {
        return started(TILT_SHARE);
    }

    /** Its receiver has a signal, or would have one. */
    public boolean isReceiving() {
        return receiving;
    }

    /** The estimator has taken over from what ran before it. */
    public boolean active() {
        return started(ACTIVE_SHARE);
    }

    /** How long it has been without a signal; 0 with one. */
    public long lostMillis() {
        return receiving ? 0 : now - lostSince;
    }

    /** It has known where it is since it was switched on. */
    public boolean hadEstimate() {
        return hadEstimate;
    }

    /** The accelerometers agree with each other. */
    public boolean accelerometersSettled() {
        return started(ACCELEROMETERS_SHARE);
    }

    public boolean gyrosSettled() {
        return started(GYROS_SHARE);
    }

    /** The place that everything is measured from is known; home is there until something is armed. */
    public boolean hasOrigin() {
        return estimate || (receiving && started(ORIGIN_SHARE));
    }

    private boolean started(double share) {
        return now - startedAt >= readyAfterMillis * share;
    }

    public boolean hasEstimate() {
        return estimate;
    }
}
