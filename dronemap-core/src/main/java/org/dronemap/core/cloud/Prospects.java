package org.dronemap.core.cloud;

import java.time.Duration;
import java.time.Instant;
import java.util.OptionalDouble;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.lease.Control;
import org.dronemap.core.lease.Lapse;
import org.dronemap.core.lease.LeaseRules;
import org.dronemap.core.safety.LandingPlace;
import org.dronemap.core.safety.ReturnLadder;
import org.dronemap.core.time.Time;
import org.jspecify.annotations.Nullable;

/** Tells once a second what becomes of one drone in the air. Owned by the drone's lane. */
final class Prospects {
    private static final long RHYTHM_NANOS = Duration.ofSeconds(1).toNanos();

    private final ManagedDrone drone;
    private final WayHome wayHome;
    private final LeaseRules rules;
    private final OutlookWords words;
    private final Time time;
    private long lookedNanos;

    Prospects(ManagedDrone drone, WayHome wayHome, LeaseRules rules, Time time) {
        this.drone = drone;
        this.wayHome = wayHome;
        this.rules = rules;
        this.words = new OutlookWords(rules);
        this.time = time;
        this.lookedNanos = time.nanos() - RHYTHM_NANOS;
    }

    void look(DroneState state, OptionalDouble secondsLeft) {
        long now = time.nanos();
        if (now - lookedNanos < RHYTHM_NANOS) {
            return;
        }
        lookedNanos = now;
        if (!FlightFacts.isFlying(state)) {
            drone.outlook(null);
            return;
        }
        Instant at = time.clock().instant();
        Control control = drone.control().control();
        Lapse lapse = control.lapse();
        boolean inMission = FlightFacts.isInMission(state);
        String user = control.people().stream().findFirst().orElse(lapse == null ? "" : lapse.user());
        ReturnLadder.Step step = wayHome.next(state, user, secondsLeft);
        drone.outlook(new Outlook(
                words.of(control, state, drone.isOurs(), inMission),
                lapse == null ? null : returnsAt(lapse, state, at, now),
                place(step, state),
                words(step),
                secondsLeft.isEmpty() ? null : at.plusMillis((long) (secondsLeft.getAsDouble() * 1_000))));
    }

    private @Nullable Instant returnsAt(Lapse lapse, DroneState state, Instant at, long now) {
        boolean waits = drone.isOurs()
                && !lapse.returned()
                && rules.onLoss() == LeaseRules.OnLoss.RETURN
                && !FlightFacts.isInMission(state)
                && !state.capabilities().isSafe(state.mode());
        return waits ? at.plusNanos(rules.untilReturn().toNanos() - (now - lapse.sinceNanos())) : null;
    }

    private static @Nullable Geodetic place(ReturnLadder.Step step, DroneState state) {
        LandingPlace place = step.place();
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

    private static @Nullable String words(ReturnLadder.Step step) {
        LandingPlace place = step.place();
        if (step.rung() == null) {
            return null;
        }
        return switch (step.rung()) {
            case RETURN -> "home";
            case ELSEWHERE -> place == null ? null : place.words();
            case LAND -> "where it is";
        };
    }
}
