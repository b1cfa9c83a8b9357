package org.dronemap.proxy.roslink;

import org.dronemap.core.drone.FlightPhase;
import org.jspecify.annotations.Nullable;

/**
 * What a robot has reported last; null what it never said. Immutable.
 *
 * @param mode its number where it is one of a flight controller
 * @param height metres above where it started
 * @param speed along any axis, the greatest, in m/s
 * @param turn about any axis, the greatest, in rad/s
 */
record RobotFacts(
        @Nullable Integer mode,
        @Nullable Boolean armed,
        @Nullable FlightPhase phase,
        @Nullable Double height,
        @Nullable Double speed,
        @Nullable Double turn) {
    static final RobotFacts NONE = new RobotFacts(null, null, null, null, null, null);

    RobotFacts flying(@Nullable Integer newMode, @Nullable Boolean newArmed, @Nullable FlightPhase newPhase) {
        return new RobotFacts(newMode, newArmed, newPhase, height, speed, turn);
    }

    RobotFacts moving(@Nullable Double newHeight, @Nullable Double newSpeed, @Nullable Double newTurn) {
        return new RobotFacts(mode, armed, phase, newHeight, newSpeed, newTurn);
    }
}
