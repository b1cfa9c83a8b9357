package org.dronemap.cognitive.operation.recovery;

import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;

/** The way of one drone down, as the space that it occupies in each step. Heights are above the sea. */
record RecoveryRoute(RecoveryDrone drone, PlanePoint here, PlanePoint there, double layerMeters, double groundMeters) {
    private static final double CLIMB_SPEED = 2;
    private static final double CRUISE_SPEED = 5;
    private static final double DESCENT_SPEED = 1;
    /** Until a command shows, and over home before it descends. */
    private static final double SETTLING_SECONDS = 5;
    /** The ground under a drone that lands where it is is not known: it may be in a valley. */
    private static final double DEEP_METERS = 1_000;

    /** {@code layerMeters}: above the sea. */
    static RecoveryRoute home(RecoveryDrone drone, LocalPlane plane, double layerMeters) {
        return new RecoveryRoute(
                drone,
                plane.spot(drone.place()),
                plane.spot(drone.home().point()),
                layerMeters,
                drone.home().altitudeAmslMeters());
    }

    static RecoveryRoute down(RecoveryDrone drone, LocalPlane plane) {
        PlanePoint here = plane.spot(drone.place());
        double ground = Math.min(drone.amslMeters(), drone.home().altitudeAmslMeters()) - DEEP_METERS;
        return new RecoveryRoute(drone, here, here, drone.amslMeters(), ground);
    }

    OccupiedBox box(RecoveryStep step) {
        double now = drone.amslMeters();
        return switch (step) {
            case ALOFT -> OccupiedBox.at(here, now, now);
            case LEVELLING -> OccupiedBox.at(here, now, layerMeters);
            case LEVEL -> OccupiedBox.at(here, layerMeters, layerMeters);
            case UNDER_WAY -> new OccupiedBox(here, there, layerMeters, layerMeters);
            case OVER_HOME -> OccupiedBox.at(there, layerMeters, layerMeters);
            case DESCENDING -> OccupiedBox.at(there, layerMeters, groundMeters);
            case DOWN -> throw new IllegalArgumentException("who is down is in nobody's way");
        };
    }

    /** Of the same drone. */
    boolean isSame(RecoveryRoute other) {
        return drone.drone().equals(other.drone.drone());
    }

    double layerAboveHome() {
        return layerMeters - drone.home().altitudeAmslMeters();
    }

    /** How long a move takes, as far as can be said. */
    double seconds(RecoveryStep move) {
        double climb = Math.abs(layerMeters - drone.amslMeters());
        double way = here.distanceMeters(there);
        return switch (move) {
            case LEVELLING -> climb == 0 ? 0 : SETTLING_SECONDS + climb / CLIMB_SPEED;
            case UNDER_WAY -> way == 0 ? 0 : SETTLING_SECONDS + way / CRUISE_SPEED;
            case DESCENDING -> SETTLING_SECONDS + Math.max(0, layerAboveHome()) / DESCENT_SPEED;
            case ALOFT, LEVEL, OVER_HOME, DOWN -> 0;
        };
    }
}
