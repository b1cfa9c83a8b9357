package org.dronemap.core.safety;

import java.util.OptionalDouble;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/**
 * Estimates how long the battery of one flying drone lasts, from its consumption in this flight. Owned by the drone's
 * lane.
 */
public final class BatteryEndurance {
    /** Assumed of a drone of which nothing is known yet: 20 minutes from full to empty. */
    private static final double ASSUMED_PERCENT_PER_SECOND = 5.0 / 60;

    private static final double LEAST_PERCENT_PER_SECOND = 0.5 / 60;
    private static final double MOST_PERCENT_PER_SECOND = 40.0 / 60;
    /** Less says nothing: a percentage is a whole number, and the take-off takes more than what follows. */
    private static final int LEAST_USED_PERCENT = 3;

    private static final double LEAST_SECONDS = 60;

    private static final double METERS_PER_SECOND = 5;
    private static final double CLIMB_METERS_PER_SECOND = 2;
    private static final double DESCENT_METERS_PER_SECOND = 1;
    /** Wind, a turn, a last look before touching down. */
    private static final double MARGIN = 1.25;

    private static final double MARGIN_SECONDS = 30;

    private @Nullable Integer firstPercent;
    private long firstNanos;
    /** The newest, and since when: between two whole numbers it goes on as before. */
    private @Nullable Integer lastPercent;

    private long lastNanos;
    private double percentPerSecond = ASSUMED_PERCENT_PER_SECOND;
    private double secondsLeft = Double.NaN;

    /** Takes in what was heard by that monotonic time. */
    public void observe(DroneState state, long nowNanos) {
        Battery battery = state.battery();
        Integer percent = battery == null ? null : battery.percent();
        if (percent == null) {
            firstPercent = null;
            lastPercent = null;
            secondsLeft = Double.NaN;
            return;
        }
        if (!state.airborne()) {
            firstPercent = null;
        } else if (firstPercent == null || percent > firstPercent) {
            firstPercent = percent;
            firstNanos = nowNanos;
        }
        if (!percent.equals(lastPercent)) {
            lastPercent = percent;
            lastNanos = nowNanos;
            percentPerSecond = percentPerSecond(percent, nowNanos);
        }
        double since = state.airborne() ? (nowNanos - lastNanos) / 1e9 : 0;
        secondsLeft = Math.max(0, percent / percentPerSecond - since);
    }

    private double percentPerSecond(int percent, long nowNanos) {
        Integer first = firstPercent;
        double seconds = (nowNanos - firstNanos) / 1e9;
        if (first == null || seconds < LEAST_SECONDS || first - percent < LEAST_USED_PERCENT) {
            return ASSUMED_PERCENT_PER_SECOND;
        }
        return Math.min(MOST_PERCENT_PER_SECOND, Math.max(LEAST_PERCENT_PER_SECOND, (first - percent) / seconds));
    }

    /** Seconds in the air until it is empty; empty: the drone does not tell how full its battery is. */
    public OptionalDouble secondsLeft() {
        return Double.isNaN(secondsLeft) ? OptionalDouble.empty() : OptionalDouble.of(secondsLeft);
    }

    /**
     * Seconds that the way to a place and down takes, with a margin; empty: it is not known where the drone is.
     *
     * @param overHomeMeters how high above its home it flies there, unless it is higher
     */
    static OptionalDouble secondsTo(DroneState state, Geodetic place, double overHomeMeters) {
        Position position = state.position();
        Geodetic here = position == null ? null : position.point();
        if (position == null || here == null) {
            return OptionalDouble.empty();
        }
        Double above = position.altitudeAboveHomeMeters();
        double height = above == null ? overHomeMeters : Math.max(0, above);
        double climb = Math.max(0, overHomeMeters - height);
        return OptionalDouble.of(MARGIN_SECONDS
                + MARGIN
                        * (climb / CLIMB_METERS_PER_SECOND
                                + Geodesy.distanceMeters(here, place) / METERS_PER_SECOND
                                + (height + climb) / DESCENT_METERS_PER_SECOND));
    }
}
