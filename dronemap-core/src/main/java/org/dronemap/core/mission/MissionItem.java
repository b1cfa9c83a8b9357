package org.dronemap.core.mission;

import java.util.Optional;
import java.util.stream.Stream;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/** One item of a mission, such as a take-off, a waypoint or a photo. */
public sealed interface MissionItem {
    /** Kinds of mission items; used in switches without a default, so that a missing case does not compile. */
    enum Kind {
        TAKE_OFF("takeOff"),
        WAYPOINT("waypoint"),
        RETURN_TO_LAUNCH("returnToLaunch"),
        LAND("land"),
        WAIT("wait"),
        TAKE_PHOTO("takePhoto"),
        SET_SERVO("setServo"),
        LOOK_AT("lookAt"),
        LOOK_AHEAD("lookAhead"),
        OTHER("other");

        private final String word;

        Kind(String word) {
            this.word = word;
        }

        /** The kind with that word; empty when there is none. */
        public static Optional<Kind> named(String word) {
            return Stream.of(values()).filter(kind -> kind.word.equals(word)).findFirst();
        }

        /** For ever: clients write it, and it is stored. */
        public String word() {
            return word;
        }
    }

    Kind kind();

    /** Climb straight up to a height in metres above home. */
    @Stored(as = "TakeOff", names = "altitudeMeters")
    record TakeOff(double altitudeMeters) implements MissionItem {
        @Override
        public Kind kind() {
            return Kind.TAKE_OFF;
        }
    }

    /** Fly through a point; wait there for {@code holdSeconds}. */
    @Stored(as = "Waypoint", names = "point altitude holdSeconds")
    record Waypoint(Geodetic point, Altitude altitude, double holdSeconds) implements MissionItem {
        @Override
        public Kind kind() {
            return Kind.WAYPOINT;
        }
    }

    /** Fly home and land there. */
    @Stored(as = "ReturnToLaunch")
    record ReturnToLaunch() implements MissionItem {
        @Override
        public Kind kind() {
            return Kind.RETURN_TO_LAUNCH;
        }
    }

    /** Land at that place; null: where it is. */
    @Stored(as = "Land", names = "place", later = "place")
    record Land(@Nullable LandingPlace place) implements MissionItem {
        /** Where it is. */
        public Land() {
            this(null);
        }

        @Override
        public Kind kind() {
            return Kind.LAND;
        }
    }

    /** Wait in the air where it is. */
    @Stored(as = "Wait", names = "seconds")
    record Wait(double seconds) implements MissionItem {
        @Override
        public Kind kind() {
            return Kind.WAIT;
        }
    }

    /** One picture, with the camera that the vehicle has. */
    @Stored(as = "TakePhoto")
    record TakePhoto() implements MissionItem {
        @Override
        public Kind kind() {
            return Kind.TAKE_PHOTO;
        }
    }

    /** The output with that number, from 1, to pulses of that length in microseconds. */
    @Stored(as = "SetServo", names = "output pulseMicros")
    record SetServo(int output, int pulseMicros) implements MissionItem {
        public static final int MOST_OUTPUTS = 32;
        public static final int SHORTEST_MICROS = 500;
        public static final int LONGEST_MICROS = 2_500;

        @Override
        public Kind kind() {
            return Kind.SET_SERVO;
        }
    }

    /** Camera and nose point to that place until the next {@link LookAhead}, wherever the drone flies. */
    @Stored(as = "LookAt", names = "point altitude")
    record LookAt(Geodetic point, Altitude altitude) implements MissionItem {
        @Override
        public Kind kind() {
            return Kind.LOOK_AT;
        }
    }

    /** No place is looked at any more. */
    @Stored(as = "LookAhead")
    record LookAhead() implements MissionItem {
        @Override
        public Kind kind() {
            return Kind.LOOK_AHEAD;
        }
    }

    /** Something found on a vehicle that the cloud does not plan itself; shown, never uploaded. */
    @Stored(as = "Other", names = "description")
    record Other(String description) implements MissionItem {
        @Override
        public Kind kind() {
            return Kind.OTHER;
        }
    }
}
