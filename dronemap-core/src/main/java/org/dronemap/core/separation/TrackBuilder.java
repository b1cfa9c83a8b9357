package org.dronemap.core.separation;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import org.dronemap.core.geo.PlanePoint;

/** Flies from place to place in thought, and notes where it is at each stride. Used once, by one thread. */
final class TrackBuilder {
    /** What goes less than that aside goes straight up or down. */
    private static final double STRAIGHT_UP_METERS = 1;

    private final FlightPace pace;
    private final int strides;
    private final List<TrackSample> samples = new ArrayList<>();
    private final double ago;
    private TrackSample here;
    private double moving;
    private double seconds;

    /**
     * Begins.
     *
     * @param ago so many seconds before now: what lies before now is passed over
     * @param moving how fast it was there, m/s
     */
    TrackBuilder(FlightPace pace, int strides, TrackSample from, double ago, double moving) {
        this.pace = pace;
        this.strides = strides;
        this.here = from;
        this.ago = ago;
        this.moving = moving;
        note(from, 0, share -> share);
    }

    TrackSample last() {
        return here;
    }

    /** Since it began. */
    double seconds() {
        return seconds;
    }

    boolean isFull() {
        return samples.size() > strides;
    }

    void to(TrackSample there) {
        double meters = here.spot().distanceMeters(there.spot());
        double climb = there.low() - here.low();
        double vertical = climb > 0 ? climb / pace.climb() : -climb / pace.descent();
        MotionProfile dash = new MotionProfile(meters, moving, pace);
        moving = 0;
        if (dash.seconds() > vertical) {
            go(there, dash.seconds(), share -> dash.share(share * dash.seconds()));
        } else {
            go(there, vertical, share -> share);
        }
    }

    void down(double ground) {
        go(new TrackSample(here.spot(), ground), Math.max(0, here.low() - ground) / pace.descent(), share -> share);
    }

    void waitFor(double holdSeconds) {
        go(here, holdSeconds, share -> share);
    }

    private void go(TrackSample there, double takes, DoubleUnaryOperator way) {
        note(there, takes, way);
        here = there;
        seconds += takes;
    }

    /** {@code way}: what share of it is behind the drone by that share of the time. */
    private void note(TrackSample there, double takes, DoubleUnaryOperator way) {
        while (samples.size() <= strides && ago + samples.size() * Track.STRIDE_SECONDS <= seconds + takes) {
            double share = takes == 0 ? 1 : (ago + samples.size() * Track.STRIDE_SECONDS - seconds) / takes;
            samples.add(between(here, there, way.applyAsDouble(share)));
        }
    }

    private static TrackSample between(TrackSample from, TrackSample there, double share) {
        double east = there.spot().eastMeters() - from.spot().eastMeters();
        double north = there.spot().northMeters() - from.spot().northMeters();
        PlanePoint spot = new PlanePoint(
                from.spot().eastMeters() + share * east, from.spot().northMeters() + share * north);
        boolean straightUp = Math.hypot(east, north) < STRAIGHT_UP_METERS;
        return straightUp
                ? new TrackSample(spot, from.low() + share * (there.low() - from.low()))
                : new TrackSample(spot, Math.min(from.low(), there.low()), Math.max(from.low(), there.low()), 0);
    }

    Track track() {
        while (samples.size() <= strides) {
            samples.add(here);
        }
        return new Track(samples);
    }
}
