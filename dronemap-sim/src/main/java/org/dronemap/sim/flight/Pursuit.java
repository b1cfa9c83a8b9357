package org.dronemap.sim.flight;

import org.dronemap.sim.physics.Position;
import org.dronemap.sim.physics.Setpoint;

/**
 * Flies with a place that moves: the autopilot moves it on by itself until it is told anew, or has heard nothing for three
 * seconds (GUID_TIMEOUT); then it stays there.
 */
public final class Pursuit implements Manoeuvre {
    private static final long FRESH_MILLIS = 3_000;

    private final Moving moving;
    private final Cruise cruise;
    private final double yaw;
    private long begun = -1;

    /** A place and its velocity in m/s. */
    public record Moving(Position place, double north, double east, double up) {
        Position after(double seconds) {
            return new Position(
                    place.north() + north * seconds, place.east() + east * seconds, place.up() + up * seconds);
        }
    }

    /** {@code yaw} in radians; NaN: as it looks already. */
    public Pursuit(Moving moving, Cruise cruise, double yaw) {
        this.moving = moving;
        this.cruise = cruise;
        this.yaw = yaw;
    }

    @Override
    public Setpoint fly(Craft craft, long nowMillis) {
        if (begun < 0) {
            begun = nowMillis;
        }
        long passed = nowMillis - begun;
        Position place = moving.after(Math.min(passed, FRESH_MILLIS) / 1000.0);
        double moves = passed < FRESH_MILLIS ? 1 : 0;
        return new Setpoint.Chase(
                cruise.to(place, yaw), moving.north() * moves, moving.east() * moves, moving.up() * moves);
    }
}
