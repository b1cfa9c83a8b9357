package org.dronemap.proxy.roslink;

import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.GoToLocal;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.proxy.roslink.wire.RobotMessage;
import org.dronemap.proxy.roslink.wire.RobotOrder;

/**
 * The state that a command shall bring a ROSLink robot to: the order to send, and the report that shows it. Immutable.
 */
sealed interface RobotGoal {
    long SECOND_NANOS = 1_000_000_000L;

    /** For how long it may take until it shows. */
    default long patienceNanos() {
        return 10 * SECOND_NANOS;
    }

    /** For how long it may be seen doing nothing for it. */
    default long idlePatienceNanos() {
        return patienceNanos();
    }

    /** After what time it is told again. */
    default long betweenNanos() {
        return SECOND_NANOS;
    }

    /** What to send next. */
    RobotOrder order(RobotStatus facts);

    /** What to send once, before that. */
    default Optional<RobotOrder> opening() {
        return Optional.empty();
    }

    /** Such a report can show it: what was reported before says nothing of now. */
    default boolean isAbout(RobotMessage report) {
        return report instanceof RobotMessage.Status status && status.state() != null;
    }

    /** The robot reports what it takes for being judged at all. */
    boolean isShownBy(RobotStatus facts);

    boolean isReached(RobotStatus facts);

    /** It is about to be reached: nothing is sent again. */
    default boolean isUnderWay(RobotStatus facts) {
        return false;
    }

    /** What is to be seen instead, for people. */
    String missing(RobotStatus facts);

    /** Empty for what these robots are not told. */
    static Optional<RobotGoal> of(Command command) {
        return switch (command.kind()) {
            case ARM -> Optional.of(new Armed(true));
            case DISARM -> Optional.of(new Armed(false));
            case SET_MODE ->
                Optional.ofNullable(RobotModes.number(((Command.SetMode) command).mode()))
                        .map(Mode::new);
            case RETURN_TO_LAUNCH -> Optional.of(new Mode(RobotModes.RETURN));
            case TAKE_OFF -> Optional.of(new Airborne(((Command.TakeOff) command).altitudeMeters()));
            case LAND -> Optional.of(new Landed());
            case GO_TO_LOCAL ->
                Optional.of(new AtPlace(((GoToLocal) command).xMeters(), ((GoToLocal) command).yMeters()));
            case READ_MAP -> Optional.of(new Mapped());
            case EMERGENCY_STOP -> Optional.of(new Stopped(Optional.of(new RobotOrder.EmergencyStop())));
            case HOLD -> Optional.of(new Stopped(Optional.empty()));
            default -> Optional.empty();
        };
    }

    /** With its motors on, or off. */
    record Armed(boolean wanted) implements RobotGoal {
        @Override
        public RobotOrder order(RobotStatus facts) {
            return wanted ? new RobotOrder.Arm() : new RobotOrder.Disarm();
        }

        @Override
        public boolean isShownBy(RobotStatus facts) {
            return facts.armed() != null;
        }

        @Override
        public boolean isReached(RobotStatus facts) {
            return Objects.equals(facts.armed(), wanted);
        }

        @Override
        public String missing(RobotStatus facts) {
            return wanted ? "it is still disarmed" : "it is still armed";
        }
    }

    /** In that mode. */
    record Mode(int number) implements RobotGoal {
        @Override
        public RobotOrder order(RobotStatus facts) {
            return new RobotOrder.SetMode(number);
        }

        @Override
        public boolean isShownBy(RobotStatus facts) {
            return facts.mode() != null;
        }

        @Override
        public boolean isReached(RobotStatus facts) {
            return Objects.equals(facts.mode(), number);
        }

        @Override
        public String missing(RobotStatus facts) {
            Integer mode = facts.mode();
            String name = mode == null ? null : RobotModes.name(mode);
            return "its mode is " + (name == null ? "another one" : name);
        }
    }

    /** In the air and as high as asked for; a flight controller takes off in GUIDED only. */
    record Airborne(double altitudeMeters) implements RobotGoal {
        /** Of the height: less than that is still on its way. */
        private static final double SHARE = 0.1;

        private static final double LEAST_METERS = 0.3;

        @Override
        public long patienceNanos() {
            return Math.round(Math.min(80, 15 + 2 * altitudeMeters) * SECOND_NANOS);
        }

        @Override
        public RobotOrder order(RobotStatus facts) {
            boolean guided = facts.mode() == null || facts.mode() == RobotModes.GUIDED;
            return guided ? new RobotOrder.TakeOff(altitudeMeters) : new RobotOrder.SetMode(RobotModes.GUIDED);
        }

        @Override
        public boolean isAbout(RobotMessage report) {
            return report instanceof RobotMessage.Motion;
        }

        @Override
        public boolean isShownBy(RobotStatus facts) {
            return facts.height() != null;
        }

        @Override
        public boolean isReached(RobotStatus facts) {
            Double height = facts.height();
            return height != null
                    && facts.phase() != FlightPhase.ON_GROUND
                    && height >= altitudeMeters - Math.max(LEAST_METERS, SHARE * altitudeMeters);
        }

        @Override
        public boolean isUnderWay(RobotStatus facts) {
            Double height = facts.height();
            return facts.phase() == FlightPhase.IN_AIR
                    || facts.phase() == FlightPhase.TAKING_OFF
                    || (height != null && height > LEAST_METERS);
        }

        @Override
        public String missing(RobotStatus facts) {
            Double height = facts.height();
            return height == null
                    ? "it tells no height"
                    : String.format(Locale.ROOT, "it is %.1f m high, not %.1f m", height, altitudeMeters);
        }
    }

    /** On the ground. */
    record Landed() implements RobotGoal {
        @Override
        public long patienceNanos() {
            return 85 * SECOND_NANOS;
        }

        @Override
        public RobotOrder order(RobotStatus facts) {
            return new RobotOrder.Land();
        }

        @Override
        public boolean isShownBy(RobotStatus facts) {
            return facts.phase() != null;
        }

        @Override
        public boolean isReached(RobotStatus facts) {
            return facts.phase() == FlightPhase.ON_GROUND;
        }

        @Override
        public String missing(RobotStatus facts) {
            return "it is still in the air";
        }
    }

    /** Standing at a place of its map. */
    record AtPlace(double xMeters, double yMeters) implements RobotGoal {
        /** As close as navigation of ground robots comes by itself, with some room. */
        private static final double NEAR_METERS = 0.35;

        @Override
        public long patienceNanos() {
            return 600 * SECOND_NANOS;
        }

        @Override
        public long idlePatienceNanos() {
            return 30 * SECOND_NANOS;
        }

        /** Told again at once, a robot would begin to plan its way anew. */
        @Override
        public long betweenNanos() {
            return 8 * SECOND_NANOS;
        }

        @Override
        public RobotOrder order(RobotStatus facts) {
            return new RobotOrder.GoTo(xMeters, yMeters, 0, false);
        }

        @Override
        public boolean isAbout(RobotMessage report) {
            return report instanceof RobotMessage.Motion;
        }

        @Override
        public boolean isShownBy(RobotStatus facts) {
            return facts.x() != null && facts.y() != null;
        }

        @Override
        public boolean isReached(RobotStatus facts) {
            return distance(facts) <= NEAR_METERS && Stopped.isStill(facts);
        }

        @Override
        public boolean isUnderWay(RobotStatus facts) {
            return facts.speed() != null && !Stopped.isStill(facts);
        }

        private double distance(RobotStatus facts) {
            Double x = facts.x();
            Double y = facts.y();
            return x == null || y == null ? Double.NaN : Math.hypot(x - xMeters, y - yMeters);
        }

        @Override
        public String missing(RobotStatus facts) {
            return String.format(Locale.ROOT, "it is %.1f m away", distance(facts));
        }
    }

    /** It has sent its map. */
    record Mapped() implements RobotGoal {
        @Override
        public RobotOrder order(RobotStatus facts) {
            return new RobotOrder.GetMap();
        }

        @Override
        public boolean isAbout(RobotMessage report) {
            return report instanceof RobotMessage.MapImage;
        }

        @Override
        public boolean isShownBy(RobotStatus facts) {
            return true;
        }

        @Override
        public boolean isReached(RobotStatus facts) {
            return facts.mapShown();
        }

        @Override
        public String missing(RobotStatus facts) {
            return "what it sent as its map is no picture";
        }
    }

    /**
     * Standing still: robots repeat the last speeds that they were told for ever, so they are told zeros.
     *
     * @param opening told once and never again: a bridge is known that dies of it after it has stopped
     */
    record Stopped(@Override Optional<RobotOrder> opening) implements RobotGoal {
        private static final double METERS_PER_SECOND = 0.05;
        private static final double RADIANS_PER_SECOND = 0.05;
        /** Links lose messages, and what still moves does not wait. */
        private static final long AGAIN_NANOS = SECOND_NANOS / 5;

        @Override
        public long betweenNanos() {
            return AGAIN_NANOS;
        }

        @Override
        public RobotOrder order(RobotStatus facts) {
            return RobotOrder.Twist.STOP;
        }

        @Override
        public boolean isAbout(RobotMessage report) {
            return report instanceof RobotMessage.Motion;
        }

        @Override
        public boolean isShownBy(RobotStatus facts) {
            return facts.speed() != null;
        }

        @Override
        public boolean isReached(RobotStatus facts) {
            return isStill(facts);
        }

        static boolean isStill(RobotStatus facts) {
            Double speed = facts.speed();
            Double turn = facts.turn();
            return speed != null && speed <= METERS_PER_SECOND && (turn == null || turn <= RADIANS_PER_SECOND);
        }

        @Override
        public String missing(RobotStatus facts) {
            return "it still moves";
        }
    }
}
