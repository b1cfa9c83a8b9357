package org.dronemap.proxy.roslink;

import org.dronemap.core.drone.FlightPhase;
import org.jspecify.annotations.Nullable;

/**
 * The last reported status of a ROSLink robot, for its commands; null where nothing was reported. Immutable.
 *
 * @param mode its number where it is one of a flight controller
 * @param mapShown the last that it sent as its map was one
 */
record RobotStatus(
        @Nullable Integer mode,
        @Nullable Boolean armed,
        @Nullable FlightPhase phase,
        Kinematics course,
        boolean mapShown) {
    static final RobotStatus NONE =
            new RobotStatus(null, null, null, new Kinematics(null, null, null, null, null), false);

    /**
     * The position and motion of a robot in its map.
     *
     * @param x metres along the axis of its map
     * @param y metres along the other axis
     * @param height metres above where it started
     * @param speed along any axis, the greatest, in m/s
     * @param turn about any axis, the greatest, in rad/s
     */
    record Kinematics(
            @Nullable Double x,
            @Nullable Double y,
            @Nullable Double height,
            @Nullable Double speed,
            @Nullable Double turn) {}

    RobotStatus flying(@Nullable Integer newMode, @Nullable Boolean newArmed, @Nullable FlightPhase newPhase) {
        return new RobotStatus(newMode, newArmed, newPhase, course, mapShown);
    }

    RobotStatus moving(Kinematics newer) {
        return new RobotStatus(mode, armed, phase, newer, mapShown);
    }

    RobotStatus mapped(boolean shown) {
        return new RobotStatus(mode, armed, phase, course, shown);
    }

    @Nullable
    Double x() {
        return course.x();
    }

    @Nullable
    Double y() {
        return course.y();
    }

    @Nullable
    Double height() {
        return course.height();
    }

    @Nullable
    Double speed() {
        return course.speed();
    }

    @Nullable
    Double turn() {
        return course.turn();
    }
}
