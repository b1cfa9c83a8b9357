package org.dronemap.cognitive.operation.follow;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronemap.cognitive.follow.Apart;
import org.dronemap.cognitive.operation.follow.FollowInput.Look;
import org.dronemap.cognitive.operation.follow.FollowInput.Looked;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.operation.Action;
import org.dronemap.core.operation.Decision;
import org.dronemap.core.operation.Guide;
import org.dronemap.core.operation.Objection;
import org.dronemap.core.operation.Operation;
import org.dronemap.core.operation.Reach;
import org.dronemap.core.operation.Scene;
import org.jspecify.annotations.Nullable;

/** Has one drone follow a phone: a function of what it remembers and of what befalls it. */
public final class Follow implements Operation<FollowState, FollowInput> {
    private static final Duration RHYTHM = Duration.ofMillis(100);
    /** So long without a position, and whoever watches is told: the drone has held for a second then. */
    private static final Duration ASKS = Duration.ofSeconds(3);

    /** So little below its height a drone counts as up. */
    private static final double RISEN_METERS = 3;

    private final Apart apart;

    /** {@code apart}: what is kept from others in the air. */
    public Follow(Apart apart) {
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
                .collect(Collectors.toUnmodifiableSet());
    }

    @Override
    public Set<DroneId> watched(FollowState state) {
        return all(state).map(FollowState::drone).collect(Collectors.toUnmodifiableSet());
    }

    /** Itself, and what it remembers of each other drone. */
    private static Stream<FollowState> all(FollowState state) {
        return Stream.concat(Stream.of(state), state.crew().others().stream());
    }

    @Override
    public Optional<Guide<FollowState>> guide(FollowState state) {
        return Optional.of(new FollowGuide(state.order().near(), apart));
    }

    @Override
    public boolean isOver(FollowState state) {
        return state.isOver();
    }

    @Override
    public FollowInput looked(FollowState state, Scene scene) {
        return new Looked(
                scene.now(),
                look(state, scene),
                scene.sighted(),
                scene.reach(),
                scene.unsteered().get(state.drone()),
                state.crew().others().stream()
                        .map(other -> new FollowInput.Other(
                                other.drone(), look(other, scene), apartMeters(state, other, scene)))
                        .toList());
    }

    /** Null as long as the other one still rises: whoever is followed would be left for one that cannot come yet. */
    private static @Nullable Double apartMeters(FollowState leader, FollowState other, Scene scene) {
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

    private static @Nullable Position position(Scene scene, DroneId drone) {
        return scene.of(drone).map(seen -> seen.state().position()).orElse(null);
    }

    private static @Nullable Look look(FollowState state, Scene scene) {
        return scene.of(state.drone())
                .map(seen -> look(state, seen.state(), seen.sway(), seen.silence()))
                .orElse(null);
    }

    private static Look look(FollowState state, DroneState drone, Scene.Sway sway, Duration silence) {
        Battery battery = drone.battery();
        Geodetic point = drone.position() == null ? null : drone.position().point();
        Steering steering =
                drone.mode() == null ? null : drone.capabilities().steering().get(drone.mode());
        return new Look(
                sway.takenBy(),
                Grips.silentSeconds(drone, silence),
                Boolean.TRUE.equals(drone.armed()),
                drone.airborne(),
                steering == Steering.ORDERS,
                steering != null && steering.isSafe(),
                drone.mode(),
                battery == null ? null : battery.percent(),
                point == null
                        ? null
                        : Geodesy.distanceMeters(point, state.order().chosen().home()),
                Grips.of(drone, sway, steering),
                new FollowInput.Modes(
                        drone.capabilities().mode(Steering.ORDERS).orElse(null), steering == Steering.HOME));
    }

    @Override
    public FollowInput ended(DroneId drone, CommandId command, Outcome outcome, Instant at) {
        return new FollowInput.CommandEnded(at, drone, command, outcome);
    }

    @Override
    public FollowInput resumed(Instant at) {
        return new FollowInput.Resumed(at);
    }

    @Override
    public Decision<FollowState, FollowInput> decide(FollowState state, FollowInput input) {
        if (state.isOver()) {
            return Decision.stay(state);
        }
        if (input instanceof FollowInput.Relieve relieve) {
            FollowState next = refusal(state, relieve).isEmpty() ? Reliefs.sent(state, relieve) : state;
            return new Decision<>(next, List.of(), news(state, next));
        }
        if (input instanceof FollowInput.Unrelieved unrelieved) {
            FollowState next = Reliefs.unrelieved(state, unrelieved);
            return new Decision<>(next, List.of(), news(state, next));
        }
        List<Action<FollowInput>> actions = new ArrayList<>();
        FollowState next = alone(state, input, Part.LEADS, actions);
        List<FollowState> others = new ArrayList<>();
        for (FollowState other : state.crew().others()) {
            FollowInput befalls = input instanceof Looked looked ? looked.of(other.drone()) : input;
            others.add(alone(other, befalls, other.wasReplacedBy(state) ? Part.REPLACED : Part.COMES, actions));
        }
        List<FollowInput.Other> seen = input instanceof Looked looked ? looked.others() : List.of();
        next = Reliefs.settled(state, next, others, input.at(), seen, apart);
        return new Decision<>(next, actions, news(state, next));
    }

    /** The role of a drone in its follow; only the leading one takes the phone's reports and users' requests. */
    private enum Part {
        LEADS,
        COMES,
        REPLACED
    }

    /** What becomes of one drone. */
    private FollowState alone(FollowState state, FollowInput input, Part part, List<Action<FollowInput>> actions) {
        if (input instanceof FollowInput.Wish wish) {
            boolean taken = part == Part.LEADS ? refusal(state, wish).isEmpty() : wish instanceof FollowInput.Change;
            return taken ? Wishes.taken(state, wish) : state;
        }
        Steps steps = new Steps(state);
        FollowState next;
        if (input instanceof Looked looked) {
            next = looked(state, looked, part, steps);
        } else if (input instanceof FollowInput.CommandEnded ended) {
            steps.ended(ended);
            next = steps.state();
        } else {
            next = Absence.over(state, input.at());
        }
        actions.addAll(steps.actions());
        return next;
    }

    private static @Nullable String news(FollowState before, FollowState next) {
        if (next.told().equals(before.told())) {
            return null;
        }
        return next.told().get(next.told().size() - 1).words();
    }

    private static FollowState looked(FollowState state, Looked looked, Part part, Steps steps) {
        Look look = looked.drone();
        Instant at = looked.at();
        String name = state.order().chosen().name();
        if (look == null) {
            return state.to(Stage.OVER, at, name + " was removed.");
        }
        if (look.takenBy() != null && state.stage().holds()) {
            return taken(state, at, name + " was taken: " + look.takenBy());
        }
        if (Grips.isBarred(state, look)) {
            return Grips.barred(state, look, at);
        }
        if (look.silentSeconds() > 0) {
            return state.noted("There is no contact with " + name + ".");
        }
        if (Grips.isPilots(state, look)) {
            return state.to(Stage.SUSPENDED, at, name + " was taken: a pilot flies it in " + look.mode() + ".");
        }
        switch (state.stage()) {
            case STARTING -> steps.start(look, at);
            case RETURNING -> {
                if (part != Part.REPLACED || !isLed(state, look, at)) {
                    steps.home(look, at);
                }
            }
            case TRACKING, PAUSED -> {
                return watched(state, looked, look, part == Part.LEADS);
            }
            case SUSPENDED -> {
                return Grips.suspended(state, look, at);
            }
            case ALLOCATED, OVER -> {
                return state;
            }
        }
        return steps.state();
    }

    private static boolean isLed(FollowState state, Look look, Instant at) {
        return look.airborne() && Homeward.isLed(state, look.guided(), look.homeMeters(), look.batteryPercent(), at);
    }

    /** Before it was started there is nothing to come back to. */
    private static FollowState taken(FollowState state, Instant at, String words) {
        return state.to(state.stage() == Stage.ALLOCATED ? Stage.OVER : Stage.SUSPENDED, at, words);
    }

    private static FollowState watched(FollowState state, Looked looked, Look look, boolean leads) {
        Instant at = looked.at();
        String name = state.order().chosen().name();
        if (!look.airborne()) {
            return look.armed()
                    ? Reliefs.leaving(state, state.to(Stage.RETURNING, at, name + " has landed."), false)
                    : state.to(Stage.OVER, at, name + " has landed" + Steps.IT_IS_OVER);
        }
        Integer percent = look.batteryPercent();
        double back = look.homeMeters() == null ? 0 : Endurance.percentBack(look.homeMeters());
        if (percent != null && percent < Endurance.RESERVE_PERCENT + back) {
            String words = String.format(
                    Locale.ROOT,
                    "%s flies home: its battery has %d %%, the way takes some %.0f %%, and %d %% are kept.",
                    name,
                    percent,
                    back,
                    Endurance.RESERVE_PERCENT);
            return Reliefs.leaving(state, state.to(Stage.RETURNING, at, words), true);
        }
        if (look.mode() != null && !look.guided()) {
            return Reliefs.leaving(state, Absence.astray(state, looked, look), false);
        }
        boolean follows = state.stage() == Stage.TRACKING;
        FollowState now = follows ? Absence.backAgain(state, looked) : state;
        return leads && follows ? heard(now, looked) : now.noted(null);
    }

    /** Whether the phone still says where it is. */
    private static FollowState heard(FollowState state, Looked looked) {
        Instant from =
                looked.sighted() == null || looked.sighted().isBefore(state.waits()) ? state.waits() : looked.sighted();
        Duration silent = Duration.between(from, looked.at());
        int patience = state.order().patienceSeconds();
        if (silent.toSeconds() >= patience) {
            return state.to(
                    Stage.RETURNING,
                    looked.at(),
                    (looked.reach() == Reach.VAGUE
                                    ? "The phone has not known well enough where it is for "
                                    : "The phone has said nothing for ")
                            + patience + " s; "
                            + state.order().chosen().name() + " flies home.");
        }
        if (silent.compareTo(ASKS) > 0) {
            Missing why = Missing.of(looked.reach());
            String words = why.words() + " " + state.order().chosen().name() + " waits, and flies home " + patience
                    + " s after the last position.";
            return why == state.missing() ? state : state.missing(why, looked.at(), words, words);
        }
        if (state.missing() != null) {
            return state.missing(null, looked.at(), "The phone says again where it is.", looked.unsteered());
        }
        // Such sentences have figures that change: each would be written down.
        return looked.unsteered() != null && state.note() != null ? state : state.noted(looked.unsteered());
    }

    @Override
    public String words(FollowState state) {
        return "The follow " + state.id();
    }

    @Override
    public Optional<Objection> refusal(FollowState state, FollowInput input) {
        return Refusals.of(state, input);
    }
}
