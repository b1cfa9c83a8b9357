package org.dronemap.cognitive.operation.follow;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronemap.cognitive.operation.CopterEndurance;
import org.dronemap.cognitive.operation.follow.FollowInput.Observation;
import org.dronemap.cognitive.operation.follow.FollowInput.Observed;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.operation.Objection;
import org.dronemap.core.operation.Operation;
import org.dronemap.core.operation.OperationAction;
import org.dronemap.core.operation.OperationDecision;
import org.dronemap.core.operation.OperationGuidance;
import org.dronemap.core.operation.OperationObservation;
import org.dronemap.core.operation.ReporterState;
import org.dronemap.core.separation.FlightIntent;
import org.dronemap.core.separation.Separation;
import org.jspecify.annotations.Nullable;

/** The state machine of a phone follow: turns each input into a new state and commands to drones. */
public final class FollowOperation implements Operation<FollowState, FollowInput> {
    /** By then it is known whether another drone is in the way of its take-off. */
    private static final Duration UNTIL_CHECKED = Duration.ofSeconds(1);

    private static final Duration RHYTHM = Duration.ofMillis(100);
    /** So long without a position, and whoever watches is told: the drone has held for a second then. */
    private static final Duration ASKS = Duration.ofSeconds(3);

    /** So little below its height a drone counts as up. */
    private static final double RISEN_METERS = 3;

    private final Separation apart;

    /** {@code apart}: what is kept from others in the air. */
    public FollowOperation(Separation apart) {
        this.apart = apart;
    }

    @Override
    public Duration rhythm() {
        return RHYTHM;
    }

    @Override
    public Set<DroneId> drones(FollowState state) {
        return all(state)
                .filter(one -> one.stage().holds())
                .map(FollowState::drone)
                .collect(Collectors.toCollection(LinkedHashSet::new));
    }

    @Override
    public Set<DroneId> watched(FollowState state) {
        return all(state).map(FollowState::drone).collect(Collectors.toCollection(LinkedHashSet::new));
    }

    /** Itself, and what it remembers of each other drone. */
    private static Stream<FollowState> all(FollowState state) {
        return Stream.concat(Stream.of(state), state.reliefOrNone().others().stream());
    }

    @Override
    public Optional<OperationGuidance<FollowState>> guidance(FollowState state) {
        return Optional.of(new FollowGuidance(state.order().near(), apart));
    }

    @Override
    public Map<DroneId, FlightIntent> intents(FollowState state, Instant now) {
        return FollowIntents.of(state, now);
    }

    @Override
    public boolean isOver(FollowState state) {
        return state.isOver();
    }

    @Override
    public FollowInput observed(FollowState state, OperationObservation scene) {
        return new Observed(
                scene.now(),
                look(state, scene),
                scene.lastReportAt(),
                scene.reach(),
                scene.refusedSetpoints().get(state.drone()),
                state.reliefOrNone().others().stream()
                        .map(other -> new FollowInput.OtherDrone(
                                other.drone(), look(other, scene), apartMeters(state, other, scene)))
                        .toList());
    }

    /** Null as long as the other one still rises: whoever is followed would be left for one that cannot come yet. */
    private static @Nullable Double apartMeters(FollowState leader, FollowState other, OperationObservation scene) {
        Position here = position(scene, leader.drone());
        Position there = position(scene, other.drone());
        Double up = there == null ? null : there.altitudeAboveHomeMeters();
        if (here == null || there == null || up == null) {
            return null;
        }
        Geodetic point = here.point();
        Geodetic comes = there.point();
        boolean risen = up >= other.order().place().heightMeters() - RISEN_METERS;
        return risen && point != null && comes != null ? Geodesy.distanceMeters(point, comes) : null;
    }

    private static @Nullable Position position(OperationObservation scene, DroneId drone) {
        return scene.of(drone).map(seen -> seen.state().position()).orElse(null);
    }

    private static @Nullable Observation look(FollowState state, OperationObservation scene) {
        return scene.of(state.drone())
                .map(seen -> look(state, seen, scene.now()))
                .orElse(null);
    }

    private static @Nullable Boolean unchecked(FollowState state, Instant now) {
        boolean early = state.stage() == FollowStage.STARTING
                && now.isBefore(state.since().plus(UNTIL_CHECKED));
        return early ? Boolean.TRUE : null;
    }

    private static Observation look(FollowState state, OperationObservation.ObservedDrone seen, Instant now) {
        DroneState drone = seen.state();
        OperationObservation.ControlStatus sway = seen.control();
        Battery battery = drone.battery();
        Geodetic point = drone.position() == null ? null : drone.position().point();
        Steering steering =
                drone.mode() == null ? null : drone.capabilities().steering().get(drone.mode());
        return new Observation(
                sway.whyNotHeld(),
                FollowControlCheck.silentSeconds(drone, seen.silence()),
                Boolean.TRUE.equals(drone.armed()),
                drone.airborne(),
                steering == Steering.ORDERS,
                steering != null && steering.isSafe(),
                drone.mode(),
                battery == null ? null : battery.percent(),
                point == null
                        ? null
                        : Geodesy.distanceMeters(point, state.order().chosen().home()),
                FollowControlCheck.of(drone, sway, steering),
                new FollowInput.ModeMeaning(
                        drone.capabilities().mode(Steering.ORDERS).orElse(null), steering == Steering.HOME),
                drone.link().trend().isFalling() ? drone.link().trend().words() : null,
                seen.giveWay(),
                unchecked(state, now));
    }

    @Override
    public FollowInput ended(DroneId drone, CommandId command, Outcome outcome, Instant at) {
        return new FollowInput.CommandEnded(at, drone, command, outcome);
    }

    @Override
    public FollowInput resumed(Instant at) {
        return new FollowInput.Restarted(at);
    }

    @Override
    public OperationDecision<FollowState, FollowInput> decide(FollowState state, FollowInput input) {
        if (state.isOver()) {
            return OperationDecision.unchanged(state);
        }
        if (input instanceof FollowInput.SendRelief relieve) {
            FollowState next = refusal(state, relieve).isEmpty() ? ReliefHandover.sendRelief(state, relieve) : state;
            return new OperationDecision<>(next, List.of(), news(state, next));
        }
        if (input instanceof FollowInput.NoReliefAvailable unrelieved) {
            FollowState next = ReliefHandover.reportNoRelief(state, unrelieved);
            return new OperationDecision<>(next, List.of(), news(state, next));
        }
        List<OperationAction<FollowInput>> actions = new ArrayList<>();
        FollowState next = decideForDrone(state, input, DroneRole.LEADS, actions);
        List<FollowState> others = new ArrayList<>();
        for (FollowState other : state.reliefOrNone().others()) {
            FollowInput befalls = input instanceof Observed looked ? looked.of(other.drone()) : input;
            others.add(decideForDrone(
                    other, befalls, other.wasReplacedBy(state) ? DroneRole.REPLACED : DroneRole.COMES, actions));
        }
        List<FollowInput.OtherDrone> seen = input instanceof Observed looked ? looked.others() : List.of();
        next = ReliefHandover.updateReliefs(state, next, others, input.at(), seen, apart);
        return new OperationDecision<>(next, actions, news(state, next));
    }

    /** The role of a drone in its follow; only the leading one takes the phone's reports and users' requests. */
    private enum DroneRole {
        LEADS,
        COMES,
        REPLACED
    }

    /** What becomes of one drone. */
    private FollowState decideForDrone(
            FollowState state, FollowInput input, DroneRole part, List<OperationAction<FollowInput>> actions) {
        if (input instanceof FollowInput.UserRequest wish) {
            boolean taken =
                    part == DroneRole.LEADS ? refusal(state, wish).isEmpty() : wish instanceof FollowInput.ChangePlace;
            return taken ? FollowUserRequests.apply(state, wish) : state;
        }
        FollowCommands steps = new FollowCommands(state);
        FollowState next;
        if (input instanceof Observed looked) {
            next = observe(state, looked, part, steps);
        } else if (input instanceof FollowInput.CommandEnded ended) {
            steps.ended(ended);
            next = steps.state();
        } else {
            next = FollowRestart.restarted(state, input.at());
        }
        actions.addAll(steps.actions());
        return next;
    }

    private static @Nullable String news(FollowState before, FollowState next) {
        if (next.notices().equals(before.notices())) {
            return null;
        }
        return next.notices().get(next.notices().size() - 1).words();
    }

    private static FollowState observe(FollowState state, Observed looked, DroneRole part, FollowCommands steps) {
        Observation look = looked.drone();
        Instant at = looked.at();
        String name = state.order().chosen().name();
        if (look == null) {
            return state.to(FollowStage.OVER, at, name + " was removed.");
        }
        if (look.whyNotHeld() != null && state.stage().holds()) {
            return suspend(state, at, name + " was taken: " + look.whyNotHeld());
        }
        if (FollowControlCheck.isRefused(state, look)) {
            return FollowControlCheck.returnOnRefusal(state, look, at);
        }
        if (look.silentSeconds() > 0) {
            return state.noted("There is no contact with " + name + ".");
        }
        if (FollowControlCheck.isUnderPilot(state, look)) {
            return state.to(FollowStage.SUSPENDED, at, name + " was taken: a pilot flies it in " + look.mode() + ".");
        }
        switch (state.stage()) {
            case STARTING -> steps.start(look, at);
            case RETURNING -> {
                if (part != DroneRole.REPLACED || !isSteered(state, look, at)) {
                    steps.home(look, at);
                }
            }
            case TRACKING, PAUSED -> {
                return checkFlight(state, looked, look, part == DroneRole.LEADS);
            }
            case SUSPENDED -> {
                return FollowControlCheck.suspended(state, look, at);
            }
            case ALLOCATED, OVER -> {
                return state;
            }
        }
        return steps.state();
    }

    private static boolean isSteered(FollowState state, Observation look, Instant at) {
        return look.airborne()
                && GuidedReturn.isSteered(state, look.guided(), look.homeMeters(), look.batteryPercent(), at);
    }

    /** Before it was started there is nothing to come back to. */
    private static FollowState suspend(FollowState state, Instant at, String words) {
        return state.to(state.stage() == FollowStage.ALLOCATED ? FollowStage.OVER : FollowStage.SUSPENDED, at, words);
    }

    private static FollowState checkFlight(FollowState state, Observed looked, Observation look, boolean leads) {
        Instant at = looked.at();
        String name = state.order().chosen().name();
        if (!look.airborne()) {
            return look.armed()
                    ? ReliefHandover.markVacancy(
                            state, state.to(FollowStage.RETURNING, at, name + " has landed."), false)
                    : state.to(FollowStage.OVER, at, name + " has landed" + FollowCommands.IT_IS_OVER);
        }
        Integer percent = look.batteryPercent();
        double back = look.homeMeters() == null ? 0 : CopterEndurance.percentBack(look.homeMeters());
        if (percent != null && percent < CopterEndurance.RESERVE_PERCENT + back) {
            String words = String.format(
                    Locale.ROOT,
                    "%s flies home: its battery has %d %%, the way takes some %.0f %%, and %d %% are kept.",
                    name,
                    percent,
                    back,
                    CopterEndurance.RESERVE_PERCENT);
            return ReliefHandover.markVacancy(state, state.to(FollowStage.RETURNING, at, words), true);
        }
        if (look.fallingLink() != null) {
            String words = name + " flies home before its link is lost. " + look.fallingLink();
            return ReliefHandover.markVacancy(state, state.to(FollowStage.RETURNING, at, words), true);
        }
        if (look.mode() != null && !look.guided()) {
            return ReliefHandover.markVacancy(state, FollowRestart.returning(state, looked, look), false);
        }
        boolean follows = state.stage() == FollowStage.TRACKING;
        FollowState now = follows ? FollowRestart.withoutRestart(state, looked) : state;
        return leads && follows ? checkFixes(now, looked) : now.noted(null);
    }

    /** Whether the phone still says where it is. */
    private static FollowState checkFixes(FollowState state, Observed looked) {
        Instant from = looked.lastReport() == null || looked.lastReport().isBefore(state.waitsSince())
                ? state.waitsSince()
                : looked.lastReport();
        Duration silent = Duration.between(from, looked.at());
        int patience = state.order().patienceSeconds();
        if (silent.toSeconds() >= patience) {
            return state.to(
                    FollowStage.RETURNING,
                    looked.at(),
                    (looked.reach() == ReporterState.VAGUE
                                    ? "The phone has not known well enough where it is for "
                                    : "The phone has said nothing for ")
                            + patience + " s; "
                            + state.order().chosen().name() + " flies home.");
        }
        if (silent.compareTo(ASKS) > 0) {
            MissingFixReason why = MissingFixReason.of(looked.reach());
            String words = why.words() + " " + state.order().chosen().name() + " waits, and flies home " + patience
                    + " s after the last position.";
            return why == state.missingFix() ? state : state.missingFix(why, looked.at(), words, words);
        }
        if (state.missingFix() != null) {
            return state.missingFix(null, looked.at(), "The phone says again where it is.", looked.steeringRefusal());
        }
        // Such sentences have figures that change: each would be written down.
        return looked.steeringRefusal() != null && state.note() != null ? state : state.noted(looked.steeringRefusal());
    }

    @Override
    public String words(FollowState state) {
        return "The follow " + state.id();
    }

    @Override
    public Optional<Objection> refusal(FollowState state, FollowInput input) {
        return FollowRefusals.of(state, input);
    }
}
