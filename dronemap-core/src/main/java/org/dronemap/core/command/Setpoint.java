package org.dronemap.core.command;

import java.util.Locale;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.jspecify.annotations.Nullable;

/**
 * A target velocity, stick position or moving point that steers a drone; the newest counts, for half a second. No
 * {@link Command}: a single one has no outcome, and one that is lost is replaced by the next.
 */
public sealed interface Setpoint {
    double WHOLE_TURN = 360;

    /** Kinds of setpoints; used in switches without a default, so that a missing case does not compile. */
    enum Kind {
        VELOCITY(Capability.VELOCITY, Steering.ORDERS),
        STICKS(Capability.STICKS, Steering.STICKS),
        TRACK(Capability.TRACK, Steering.ORDERS);

        private final Capability needs;
        private final Steering steering;

        Kind(Capability needs, Steering steering) {
            this.needs = needs;
            this.steering = steering;
        }

        /** What a vehicle must go by in its mode to be steered so. */
        public Steering steering() {
            return steering;
        }
    }

    Kind kind();

    /** What the vehicle must be able to do for it. */
    default Capability needs() {
        return kind().needs;
    }

    /** What whoever says this does, for people: "steer by sticks". */
    String summary();

    /** What stands for no movement, said in the same way. */
    Setpoint still();

    default boolean isStill() {
        return equals(still());
    }

    /** Reference frame of a velocity: the vehicle's body (forward, right, down) or the earth (north, east, down). */
    enum Frame {
        /** Forward, right and down as the vehicle stands. */
        VEHICLE,
        /** True north, east and down. */
        EARTH
    }

    /** Yaw of a vehicle while it moves: any, a fixed heading or a turn rate. */
    sealed interface Facing {
        /** As the vehicle likes. */
        Facing ANY = new Any();

        record Any() implements Facing {}

        /** −360 to 360 degrees clockwise from true north. */
        record Heading(double degrees) implements Facing {
            public Heading {
                within("heading", degrees, WHOLE_TURN);
            }
        }

        /** −360 to 360 degrees a second, clockwise seen from above. */
        record Turning(double degreesPerSecond) implements Facing {
            public Turning {
                within("turn", degreesPerSecond, WHOLE_TURN);
                degreesPerSecond += 0.0;
            }
        }
    }

    /**
     * Move with a speed, each direction −100 to 100 m/s.
     *
     * @param forward m/s forward, or north
     * @param right m/s to the right, or east
     * @param down m/s downwards; ground robots know none
     * @param facing where it looks meanwhile
     */
    record Velocity(Frame frame, double forward, double right, double down, Facing facing) implements Setpoint {
        /** m/s in each direction. */
        public static final double FASTEST = 100;

        public Velocity {
            within("forward", forward, FASTEST);
            within("right", right, FASTEST);
            within("down", down, FASTEST);
            // There is one way to stand still.
            forward += 0.0;
            right += 0.0;
            down += 0.0;
        }

        @Override
        public Kind kind() {
            return Kind.VELOCITY;
        }

        @Override
        public String summary() {
            return "steer by speeds";
        }

        @Override
        public Velocity still() {
            return new Velocity(frame, 0, 0, 0, facing instanceof Facing.Turning ? new Facing.Turning(0) : facing);
        }
    }

    /**
     * Positions of a pilot's sticks, each −1 to 1 with 0 in the middle.
     *
     * @param forward pitch; a ground vehicle's throttle
     * @param right roll
     * @param up throttle; 0 keeps the height where the mode keeps one
     * @param turn yaw, clockwise; a ground vehicle's steering
     */
    record Sticks(double forward, double right, double up, double turn) implements Setpoint {
        public Sticks {
            within("forward", forward, 1);
            within("right", right, 1);
            within("up", up, 1);
            within("turn", turn, 1);
            forward += 0.0;
            right += 0.0;
            up += 0.0;
            turn += 0.0;
        }

        @Override
        public Kind kind() {
            return Kind.STICKS;
        }

        @Override
        public String summary() {
            return "steer by sticks";
        }

        @Override
        public Sticks still() {
            return new Sticks(0, 0, 0, 0);
        }
    }

    /**
     * Be at a place that moves.
     *
     * @param moving how the place itself moves, counted from {@link Frame#EARTH}; null: not known
     * @param facing where it looks meanwhile
     * @param cameraElevationDegrees how far its camera looks above the horizon, −90 to 90, if it has a gimbal; null: as it likes
     */
    record Track(
            Geodetic point,
            Altitude altitude,
            @Nullable Velocity moving,
            Facing facing,
            @Nullable Double cameraElevationDegrees)
            implements Setpoint {
        private static final double STEEPEST = 90;

        public Track {
            if (moving != null && moving.frame() != Frame.EARTH) {
                throw new IllegalArgumentException("how a place moves is counted from true north");
            }
            if (cameraElevationDegrees != null) {
                within("gaze", cameraElevationDegrees, STEEPEST);
            }
        }

        public Track(Geodetic point, Altitude altitude, @Nullable Velocity moving, Facing facing) {
            this(point, altitude, moving, facing, null);
        }

        @Override
        public Kind kind() {
            return Kind.TRACK;
        }

        @Override
        public String summary() {
            return "lead it by a place";
        }

        @Override
        public Velocity still() {
            return new Velocity(Frame.EARTH, 0, 0, 0, Facing.ANY);
        }
    }

    private static void within(String field, double value, double most) {
        if (!(Math.abs(value) <= most)) {
            throw new IllegalArgumentException(
                    String.format(Locale.ROOT, "%s must be %.0f to %.0f: %s", field, -most, most, value));
        }
    }
}
