package org.dronemap.core.cloud;

import java.time.Duration;
import java.time.Instant;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronemap.core.cloud.outlook.Outlook;
import org.dronemap.core.cloud.outlook.OutlookMessages;
import org.dronemap.core.cloud.rule.FlightFacts;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.lease.ControlState;
import org.dronemap.core.lease.LapsedLease;
import org.dronemap.core.lease.Lease;
import org.dronemap.core.lease.LeaseRules;
import org.dronemap.core.safety.LandingSite;
import org.dronemap.core.safety.ReturnEnding;
import org.dronemap.core.safety.ReturnOption;
import org.dronemap.core.safety.ReturnPlanner;
import org.dronemap.core.time.Time;
import org.jspecify.annotations.Nullable;

/**
 * Updates once a second the forecast of what happens to one flying drone when control of it ends. Owned by the drone's
 * lane.
 */
final class OutlookWatch {
    private static final long RHYTHM_NANOS = Duration.ofSeconds(1).toNanos();

    private final ManagedDrone drone;
    private final ReturnWatch returning;
    private final LeaseRules rules;
    private final OutlookMessages words;
    private final Time time;
    private long lookedNanos;
    private @Nullable String mode;

    OutlookWatch(ManagedDrone drone, ReturnWatch returning, LeaseRules rules, Time time) {
        this.drone = drone;
        this.returning = returning;
        this.rules = rules;
        this.words = new OutlookMessages(rules);
        this.time = time;
        this.lookedNanos = time.nanos() - RHYTHM_NANOS;
    }

    /** Once a second, and as soon as its mode is another one. */
    void lookAgain(DroneState state, OptionalDouble secondsLeft) {
        if (time.nanos() - lookedNanos >= RHYTHM_NANOS || !Objects.equals(mode, state.mode())) {
            update(state, secondsLeft);
        }
    }

    void update(DroneState state, OptionalDouble secondsLeft) {
        long now = time.nanos();
        lookedNanos = now;
        mode = state.mode();
        if (!FlightFacts.isFlying(state)) {
            drone.outlook(null);
            return;
        }
        Instant at = time.clock().instant();
        ControlState control = drone.control().control();
        LapsedLease lapse = control.lapse();
        Lease tenure = control.tenure();
        String user = Optional.ofNullable(tenure)
                .flatMap(has -> has.holder().userName())
                .orElse(lapse == null ? "" : lapse.user());
        ReturnPlanner.PlannedReturn step = returning.next(state, user, secondsLeft);
        Outlook.State is = words.state(control, state, drone.isCommandedFromHere(), step.rung() != null);
        // Where nothing is done about it, it comes down nowhere that is known here.
        boolean brought = is != Outlook.State.LEFT_ALONE && words.returns();
        ReturnEnding end = brought && step.rung() == ReturnOption.RETURN
                ? ReturnEnding.of(state, drone.preparation().state().action())
                : ReturnEnding.LANDS;
        drone.outlook(new Outlook(
                is,
                words.of(is, control, state) + OutlookMessages.atHome(end),
                lapse == null || is != Outlook.State.WAITS ? null : returnsAt(lapse, state, at, now),
                brought && end == ReturnEnding.LANDS ? place(step, state) : null,
                brought ? words(step, end) : null,
                secondsLeft.isEmpty() ? null : at.plusMillis((long) (secondsLeft.getAsDouble() * 1_000))));
    }

    private @Nullable Instant returnsAt(LapsedLease lapse, DroneState state, Instant at, long now) {
        return FlightFacts.isInMission(state)
                ? null
                : at.plusNanos(rules.untilReturn().toNanos() - (now - lapse.sinceNanos()));
    }

    private static @Nullable Geodetic place(ReturnPlanner.PlannedReturn step, DroneState state) {
        LandingSite place = step.place();
        if (step.rung() == null) {
            return null;
        }
        return switch (step.rung()) {
            case RETURN -> {
                Home home = state.home();
                yield home == null ? null : home.point();
            }
            case ELSEWHERE -> place == null ? null : place.point();
            case LAND -> {
                Position position = state.position();
                yield position == null ? null : position.point();
            }
        };
    }

    private static @Nullable String words(ReturnPlanner.PlannedReturn step, ReturnEnding end) {
        LandingSite place = step.place();
        if (step.rung() == null) {
            return null;
        }
        return switch (step.rung()) {
            case RETURN -> home(end);
            case ELSEWHERE -> place == null ? null : place.words();
            case LAND -> "where it is";
        };
    }

    private static @Nullable String home(ReturnEnding end) {
        return switch (end) {
            case LANDS -> "home";
            case LANDS_BY_MISSION -> "at the end of its landing sequence";
            case CIRCLES, NOT_KNOWN -> null;
        };
    }
}
