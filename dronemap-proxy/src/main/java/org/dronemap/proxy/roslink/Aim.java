package org.dronemap.proxy.roslink;

import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.proxy.roslink.wire.Order;
import org.dronemap.proxy.roslink.wire.RobotMessage;

/** What a command wants of a robot: the order for it, and by which report it shows. Immutable. */
sealed interface Aim {
    long SECOND_NANOS = 1_000_000_000L;

    /** For how long it may take until it shows. */
    default long patienceNanos() {
        return 10 * SECOND_NANOS;
    }

    /** What to send next. */
    Order order(RobotFacts facts);

    /** Such a report can show it: what was reported before says nothing of now. */
    default boolean isAbout(RobotMessage report) {
        return report instanceof RobotMessage.Status status && status.state() != null;
    }

    /** The robot reports what it takes for being judged at all. */
    boolean isShownBy(RobotFacts facts);

    boolean isReached(RobotFacts facts);

    /** It is about to be reached: nothing is sent again. */
    default boolean isUnderWay(RobotFacts facts) {
        return false;
    }

    /** What is to be seen instead, for people. */
    String missing(RobotFacts facts);

    /** Empty for what these robots are not told. */
    static Optional<Aim> of(Command command) {
        if (command instanceof Command.Arm) {
            return Optional.of(new Armed(true));
        }
        if (command instanceof Command.Disarm) {
            return Optional.of(new Armed(false));
        }
        if (command instanceof Command.SetMode setMode) {
            return Optional.ofNullable(RobotModes.number(setMode.mode())).map(Mode::new);
        }
        if (command instanceof Command.ReturnToLaunch) {
            return Optional.of(new Mode(RobotModes.RETURN));
        }
        if (command instanceof Command.TakeOff takeOff) {
            return Optional.of(new Airborne(takeOff.altitudeMeters()));
        }
        if (command instanceof Command.Land) {
            return Optional.of(new Landed());
        }
        return command instanceof Command.Hold ? Optional.of(new Still()) : Optional.empty();
    }

    /** With its motors on, or off. */
    record Armed(boolean wanted) implements Aim {
        @Override
        public Order order(RobotFacts facts) {
            return wanted ? new Order.Arm() : new Order.Disarm();
        }

        @Override
        public boolean isShownBy(RobotFacts facts) {
            return facts.armed() != null;
        }

        @Override
        public boolean isReached(RobotFacts facts) {
            return Objects.equals(facts.armed(), wanted);
        }

        @Override
        public String missing(RobotFacts facts) {
            return wanted ? "it is still disarmed" : "it is still armed";
        }
    }

    /** In that mode. */
    record Mode(int number) implements Aim {
        @Override
        public Order order(RobotFacts facts) {
            return new Order.SetMode(number);
        }

        @Override
        public boolean isShownBy(RobotFacts facts) {
            return facts.mode() != null;
        }

        @Override
        public boolean isReached(RobotFacts facts) {
            return Objects.equals(facts.mode(), number);
        }

        @Override
        public String missing(RobotFacts facts) {
            Integer mode = facts.mode();
            String name = mode == null ? null : RobotModes.name(mode);
            return "its mode is " + (name == null ? "another one" : name);
        }
    }

    /** In the air and as high as asked for; a flight controller takes off in GUIDED only. */
    record Airborne(double altitudeMeters) implements Aim {
        /** Of the height: less than that is still on its way. */
        private static final double SHARE = 0.1;

        private static final double LEAST_METERS = 0.3;

        @Override
        public long patienceNanos() {
            return Math.round(Math.min(80, 15 + 2 * altitudeMeters) * SECOND_NANOS);
        }

        @Override
        public Order order(RobotFacts facts) {
            boolean guided = facts.mode() == null || facts.mode() == RobotModes.GUIDED;
            return guided ? new Order.TakeOff(altitudeMeters) : new Order.SetMode(RobotModes.GUIDED);
        }

        @Override
        public boolean isAbout(RobotMessage report) {
            return report instanceof RobotMessage.Motion;
        }

        @Override
        public boolean isShownBy(RobotFacts facts) {
            return facts.height() != null;
        }

        @Override
        public boolean isReached(RobotFacts facts) {
            Double height = facts.height();
            return height != null
                    && facts.phase() != FlightPhase.ON_GROUND
                    && height >= altitudeMeters - Math.max(LEAST_METERS, SHARE * altitudeMeters);
        }

        @Override
        public boolean isUnderWay(RobotFacts facts) {
            Double height = facts.height();
            return facts.phase() == FlightPhase.IN_AIR
                    || facts.phase() == FlightPhase.TAKING_OFF
                    || (height != null && height > LEAST_METERS);
        }

        @Override
        public String missing(RobotFacts facts) {
            Double height = facts.height();
            return height == null
                    ? "it tells no height"
                    : String.format(Locale.ROOT, "it is %.1f m high, not %.1f m", height, altitudeMeters);
        }
    }

    /** On the ground. */
    record Landed() implements Aim {
        @Override
        public long patienceNanos() {
            return 85 * SECOND_NANOS;
        }

        @Override
        public Order order(RobotFacts facts) {
            return new Order.Land();
        }

        @Override
        public boolean isShownBy(RobotFacts facts) {
            return facts.phase() != null;
        }

        @Override
        public boolean isReached(RobotFacts facts) {
            return facts.phase() == FlightPhase.ON_GROUND;
        }

        @Override
        public String missing(RobotFacts facts) {
            return "it is still in the air";
        }
    }

    /** Standing still: robots repeat the last speeds that they were told for ever, so they are told zeros. */
    record Still() implements Aim {
        private static final double METERS_PER_SECOND = 0.05;
        private static final double RADIANS_PER_SECOND = 0.05;

        @Override
        public Order order(RobotFacts facts) {
            return Order.Twist.STOP;
        }

        @Override
        public boolean isAbout(RobotMessage report) {
            return report instanceof RobotMessage.Motion;
        }

        @Override
        public boolean isShownBy(RobotFacts facts) {
            return facts.speed() != null;
        }

        @Override
        public boolean isReached(RobotFacts facts) {
            Double speed = facts.speed();
            Double turn = facts.turn();
            return speed != null && speed <= METERS_PER_SECOND && (turn == null || turn <= RADIANS_PER_SECOND);
        }

        @Override
        public String missing(RobotFacts facts) {
            return "it still moves";
        }
    }
}
