package org.dronemap.core.mission;

import org.dronemap.core.geo.Geodetic;

/** One step of a mission. */
public sealed interface MissionItem {
    /** Climb straight up to a height in metres above home. */
    record TakeOff(double altitudeMeters) implements MissionItem {}

    /** Fly through a point; wait there for {@code holdSeconds}. */
    record Waypoint(Geodetic point, Altitude altitude, double holdSeconds) implements MissionItem {}

    /** Fly home and land there. */
    record ReturnToLaunch() implements MissionItem {}

    /** Land where it is. */
    record Land() implements MissionItem {}

    /** Wait in the air where it is. */
    record Wait(double seconds) implements MissionItem {}

    /** Done where the drone is when its turn comes; it has no place in the way and takes no time of its own. */
    sealed interface Action extends MissionItem {}

    /** One picture, with the camera that the vehicle has. */
    record TakePhoto() implements Action {}

    /** The output with that number, from 1, to pulses of that length in microseconds. */
    record SetServo(int output, int pulseMicros) implements Action {
        public static final int MOST_OUTPUTS = 32;
        public static final int SHORTEST_MICROS = 500;
        public static final int LONGEST_MICROS = 2_500;
    }

    /** Camera and nose point to that place until the next {@link LookAhead}, wherever the drone flies. */
    record LookAt(Geodetic point, Altitude altitude) implements Action {}

    /** No place is looked at any more. */
    record LookAhead() implements Action {}

    /** Something found on a vehicle that the cloud does not plan itself; shown, never uploaded. */
    record Other(String description) implements MissionItem {}
}
