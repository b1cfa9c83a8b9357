package org.dronemap.core.mission;

import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.stored.Stored;

/** Task of a drone of a mission run at a waypoint: take a photo, move a servo, look at a point, read sensors. */
public sealed interface WaypointTask {
    /** How long the drone stays for it. */
    double seconds();

    /** Doing it once more would be something else, so that it is not done again when it may have been done. */
    default boolean isOnce() {
        return false;
    }

    /** One picture. */
    @Stored(as = "Photo")
    record Photo() implements WaypointTask {
        private static final double SECONDS = 2;

        @Override
        public double seconds() {
            return SECONDS;
        }

        @Override
        public boolean isOnce() {
            return true;
        }
    }

    /** An output of the vehicle to pulses of that length. */
    @Stored(as = "Servo", names = "output pulseMicros")
    record Servo(int output, int pulseMicros) implements WaypointTask {
        private static final double SECONDS = 2;

        @Override
        public double seconds() {
            return SECONDS;
        }

        @Override
        public boolean isOnce() {
            return true;
        }
    }

    /** Camera and nose point to a place while the drone is at the waypoint. */
    @Stored(as = "Look", names = "point altitudeAmslMeters")
    record Look(Geodetic point, double altitudeAmslMeters) implements WaypointTask {
        private static final double SECONDS = 3;

        @Override
        public double seconds() {
            return SECONDS;
        }
    }

    /** It stays for so long, and what its sensors tell meanwhile is kept. */
    @Stored(as = "Sensors", names = "seconds")
    record Sensors(double seconds) implements WaypointTask {}
}
