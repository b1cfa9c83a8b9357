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

    /** Something found on a vehicle that the cloud does not plan itself; shown, never uploaded. */
    record Other(String description) implements MissionItem {}
}
