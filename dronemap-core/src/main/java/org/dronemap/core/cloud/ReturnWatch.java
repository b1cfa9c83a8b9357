package org.dronemap.core.cloud;

import java.time.Clock;
import java.time.Duration;
import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.dronemap.core.cloud.rule.CommandTracker;
import org.dronemap.core.cloud.rule.KnownLandingSites;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.safety.LandingSite;
import org.dronemap.core.safety.ReturnOption;
import org.dronemap.core.safety.ReturnPlanner;
import org.dronemap.core.time.Time;
import org.dronemap.core.zone.RouteObjection;
import org.dronemap.core.zone.ZoneRules;
import org.jspecify.annotations.Nullable;

/**
 * Brings a flying drone home or down after control ended and nobody took over; tries the next best way on failure.
 * Owned by the drone's lane.
 */
final class ReturnWatch {
    /** What was tried in vain is not tried again for so long. */
    private static final long FAILED_NANOS = Duration.ofSeconds(30).toNanos();
    /** A vehicle on its way moves within so long; landing ones wait over their home for some seconds. */
    private static final long STUCK_NANOS = Duration.ofSeconds(60).toNanos();

    private static final long BETWEEN_ALARMS_NANOS = Duration.ofSeconds(30).toNanos();
    private static final double ARRIVED_METERS = 3;
    private static final double MOVED_METERS = 2;

    private final ManagedDrone drone;
    private final CommandGate gate;
    private final ZoneRules zones;
    private final KnownLandingSites places;
    private final Time time;
    private final Clock clock;
    private final Map<ReturnOption, Long> failedNanos = new EnumMap<>(ReturnOption.class);
    private @Nullable Attempt attempt;
    private long alarmedNanos;
    private boolean alarmed;

    /** One attempt to return or land a drone: the command sent, and since when the drone has not moved. */
    private static final class Attempt {
        private final ReturnOption rung;
        private final @Nullable LandingSite place;
        private @Nullable CommandTracker command;
        private boolean landing;
        private @Nullable Position anchor;
        private long anchorNanos;

        /** {@code command}: null, somebody else did. */
        Attempt(ReturnOption rung, @Nullable LandingSite place, @Nullable CommandTracker command, long nowNanos) {
            this.rung = rung;
            this.place = place;
            this.command = command;
            this.landing = rung == ReturnOption.LAND;
            this.anchorNanos = nowNanos;
        }

        boolean isUnderWay() {
            return command != null && command.record().outcome() == null;
        }

        boolean commandSucceeded() {
            return command == null || command.record().outcome() instanceof Outcome.Succeeded;
        }

        boolean isStuck(@Nullable Position now, long nowNanos) {
            if (now != null && hasMoved(anchor, now)) {
                anchor = now;
                anchorNanos = nowNanos;
            }
            return nowNanos - anchorNanos > STUCK_NANOS;
        }

        private static boolean hasMoved(@Nullable Position before, Position now) {
            Geodetic from = before == null ? null : before.point();
            Geodetic to = now.point();
            Double low = before == null ? null : before.altitudeAboveHomeMeters();
            Double high = now.altitudeAboveHomeMeters();
            return before == null
                    || (from != null && to != null && Geodesy.distanceMeters(from, to) > MOVED_METERS)
                    || (low != null && high != null && Math.abs(high - low) > MOVED_METERS / 2);
        }
    }

    ReturnWatch(ManagedDrone drone, CommandGate gate, ZoneRules zones, Time time) {
        this.drone = drone;
        this.gate = gate;
        this.zones = zones;
        this.places = new KnownLandingSites();
        this.time = time;
        this.clock = time.clock();
    }

    /** Nobody is to bring it home now. */
    void rest(DroneState state) {
        places.observe(state);
        attempt = null;
        failedNanos.clear();
        alarmed = false;
    }

    /** {@code user}: who had control; what binds that user binds the way home. */
    void update(DroneState state, String user, OptionalDouble secondsLeft) {
        long now = time.nanos();
        Attempt tried = attempt;
        if (tried != null && tried.isUnderWay()) {
            return;
        }
        if (tried != null && isGoing(tried, state, now)) {
            return;
        }
        if (tried != null) {
            failedNanos.put(tried.rung, now);
            attempt = null;
        } else if (state.capabilities().isSafe(state.mode())) {
            // Somebody has told it already, or its own fail-safe has; from here on it is looked after.
            attempt = new Attempt(ReturnOption.RETURN, null, null, now);
            return;
        }
        begin(state, user, secondsLeft, now);
    }

    private boolean isGoing(Attempt tried, DroneState state, long now) {
        if (!tried.commandSucceeded() || tried.isStuck(state.position(), now)) {
            return false;
        }
        // One without modes is judged by how it moves.
        if (state.mode() == null || state.capabilities().isSafe(state.mode())) {
            return true;
        }
        LandingSite place = tried.place;
        if (place == null || tried.landing) {
            return false;
        }
        if (isAt(place, state)) {
            tried.landing = true;
            gate.submitForSafety(drone, new Command.Land()).ifPresent(told -> tried.command = told);
        }
        return true;
    }

    private static boolean isAt(LandingSite place, DroneState state) {
        Position position = state.position();
        Geodetic here = position == null ? null : position.point();
        return here != null && Geodesy.distanceMeters(here, place.point()) <= ARRIVED_METERS;
    }

    private void begin(DroneState state, String user, OptionalDouble secondsLeft, long now) {
        failedNanos.values().removeIf(failed -> now - failed > FAILED_NANOS);
        ReturnPlanner.PlannedReturn step = next(state, user, secondsLeft);
        ReturnOption rung = step.rung();
        Command command = step.command();
        if (rung == null || command == null) {
            alarm(step.why(), secondsLeft, now);
            return;
        }
        gate.submitForSafety(drone, command).ifPresent(told -> {
            attempt = new Attempt(rung, step.place(), told, now);
            publishStep(step);
        });
    }

    /** What would be done now. */
    ReturnPlanner.PlannedReturn next(DroneState state, String user, OptionalDouble secondsLeft) {
        return ReturnPlanner.next(
                new ReturnPlanner.Situation(
                        state, secondsLeft, places.known(drone.drone().onBoard()), Set.copyOf(failedNanos.keySet())),
                against(state, user));
    }

    private ReturnPlanner.ZoneCheck against(DroneState state, String user) {
        return new ReturnPlanner.ZoneCheck() {
            @Override
            public Optional<String> againstReturn() {
                return zones.homewardDoubt(user, state, clock.instant());
            }

            @Override
            public Optional<String> against(Command.GoTo way) {
                return zones.whyNot(user, state, way, clock.instant()).map(RouteObjection::sentence);
            }

            @Override
            public Optional<String> againstLanding() {
                return zones.landingDoubt(user, state, clock.instant());
            }
        };
    }

    private void publishStep(ReturnPlanner.PlannedReturn step) {
        LandingSite place = step.place();
        if (step.rung() == ReturnOption.LAND) {
            drone.publishMessage(Severity.ALERT, step.why() + " It lands where it is.");
        } else if (place != null) {
            drone.publishMessage(Severity.CRITICAL, step.why() + " It flies to " + place.words() + " and lands there.");
        }
    }

    private void alarm(String why, OptionalDouble secondsLeft, long now) {
        if (alarmed && now - alarmedNanos < BETWEEN_ALARMS_NANOS) {
            return;
        }
        alarmed = true;
        alarmedNanos = now;
        String left = secondsLeft.isEmpty()
                ? "How long its battery lasts is not known."
                : String.format(Locale.ROOT, "Its battery lasts for about %.0f min.", secondsLeft.getAsDouble() / 60);
        drone.publishMessage(
                Severity.ALERT, "It is in the air and nobody's. " + why + " " + left + " Take control of it.");
    }
}
