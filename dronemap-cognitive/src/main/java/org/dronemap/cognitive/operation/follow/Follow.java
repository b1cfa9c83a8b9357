package org.dronemap.cognitive.operation.follow;

import java.time.Duration;
import java.time.Instant;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.dronemap.cognitive.operation.follow.FollowInput.Look;
import org.dronemap.cognitive.operation.follow.FollowInput.Looked;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.operation.Decision;
import org.dronemap.core.operation.Guide;
import org.dronemap.core.operation.Operation;
import org.dronemap.core.operation.Scene;
import org.jspecify.annotations.Nullable;

/** Has one drone follow a phone: a function of what it remembers and of what befalls it. */
public final class Follow implements Operation<FollowState, FollowInput> {
    private static final Duration RHYTHM = Duration.ofMillis(100);
    /** So long without a position, and whoever watches is told. */
    private static final Duration ASKS = Duration.ofSeconds(10);
    /** That much is to be in the battery when it is home. */
    private static final int RESERVE_PERCENT = 20;
    /** What the way home takes: 5 % a minute at 5 m/s. */
    private static final double PERCENT_PER_METER = 5.0 / 60 / 5;

    @Override
    public Duration rhythm() {
        return RHYTHM;
    }

    @Override
    public Set<DroneId> drones(FollowState state) {
        return state.stage().holds() ? Set.of(state.drone()) : Set.of();
    }

    @Override
    public Set<DroneId> watched(FollowState state) {
        return Set.of(state.drone());
    }

    @Override
    public Optional<Guide<FollowState>> guide(FollowState state) {
        return Optional.of(new FollowGuide(state.order()));
    }

    @Override
    public boolean isOver(FollowState state) {
        return state.isOver();
    }

    @Override
    public FollowInput looked(FollowState state, Scene scene) {
        Look look = scene.of(state.drone())
                .map(seen -> look(state, seen.state(), seen.takenBy(), seen.silence()))
                .orElse(null);
        return new Looked(scene.now(), look, scene.sighted(), scene.unsteered().get(state.drone()));
    }

    private static Look look(FollowState state, DroneState drone, @Nullable String takenBy, Duration silence) {
        Battery battery = drone.battery();
        Geodetic point = drone.position() == null ? null : drone.position().point();
        Steering steering =
                drone.mode() == null ? null : drone.capabilities().steering().get(drone.mode());
        return new Look(
                takenBy,
                (int) silence.toSeconds(),
                Boolean.TRUE.equals(drone.armed()),
                drone.airborne(),
                steering == Steering.ORDERS,
                steering == Steering.SAFETY,
                drone.mode(),
                battery == null ? null : battery.percent(),
                point == null
                        ? null
                        : Geodesy.distanceMeters(point, state.order().chosen().home()));
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
        Steps steps = new Steps(state);
        FollowState next;
        if (input instanceof Looked looked) {
            next = looked(state, looked, steps);
        } else if (input instanceof FollowInput.CommandEnded ended) {
            steps.ended(ended);
            next = steps.state();
        } else if (input instanceof FollowInput.Wish wish) {
            next = refusal(state, wish).isEmpty() ? Wishes.taken(state, wish) : state;
        } else {
            // What the phone says is heard anew.
            next = state.waiting(input.at());
        }
        return new Decision<>(next, steps.actions(), news(state, next));
    }

    private static @Nullable String news(FollowState before, FollowState next) {
        if (next.told().equals(before.told())) {
            return null;
        }
        return next.told().get(next.told().size() - 1).words();
    }

    private static FollowState looked(FollowState state, Looked looked, Steps steps) {
        Look look = looked.drone();
        Instant at = looked.at();
        String name = state.order().chosen().name();
        if (look == null) {
            return state.to(Stage.OVER, at, name + " was removed.");
        }
        if (look.takenBy() != null && state.stage().holds()) {
            return taken(state, at, name + " was taken: " + look.takenBy());
        }
        if (look.silentSeconds() > 0) {
            return state.noted("There is no contact with " + name + ".");
        }
        switch (state.stage()) {
            case STARTING -> steps.start(look, at);
            case RETURNING -> steps.home(look, at);
            case TRACKING, PAUSED -> {
                return watched(state, looked, look);
            }
            case SUSPENDED -> {
                return look.armed() ? state : state.to(Stage.OVER, at, name + " is down; it is over.");
            }
            case ALLOCATED, OVER -> {
                return state;
            }
        }
        return steps.state();
    }

    /** On the ground there is nothing to come back to. */
    private static FollowState taken(FollowState state, Instant at, String words) {
        boolean over = state.stage() == Stage.ALLOCATED || state.stage() == Stage.RETURNING;
        return state.to(over ? Stage.OVER : Stage.SUSPENDED, at, words);
    }

    private static FollowState watched(FollowState state, Looked looked, Look look) {
        Instant at = looked.at();
        String name = state.order().chosen().name();
        if (!look.airborne()) {
            return look.armed()
                    ? state.to(Stage.RETURNING, at, name + " has landed.")
                    : state.to(Stage.OVER, at, name + " has landed; it is over.");
        }
        Integer percent = look.batteryPercent();
        double back = look.homeMeters() == null ? 0 : look.homeMeters() * PERCENT_PER_METER;
        if (percent != null && percent < RESERVE_PERCENT + back) {
            return state.to(
                    Stage.RETURNING,
                    at,
                    String.format(
                            Locale.ROOT,
                            "%s flies home: its battery has %d %%, the way takes some %.0f %%, and %d %% are kept.",
                            name,
                            percent,
                            back,
                            RESERVE_PERCENT));
        }
        if (look.mode() != null && !look.guided()) {
            return state.to(Stage.RETURNING, at, name + " went into " + look.mode() + "; it flies home.");
        }
        return state.stage() == Stage.TRACKING ? heard(state, looked) : state.noted(null);
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
                    "The phone has said nothing for " + patience + " s; "
                            + state.order().chosen().name() + " flies home.");
        }
        if (silent.compareTo(ASKS) > 0) {
            return state.noted("The phone says nothing any more; "
                    + state.order().chosen().name() + " waits, and flies home " + patience
                    + " s after the last position.");
        }
        // Such sentences have figures that change: each would be written down.
        return looked.unsteered() != null && state.note() != null ? state : state.noted(looked.unsteered());
    }

    @Override
    public String words(FollowState state) {
        return "The follow " + state.id();
    }

    @Override
    public Optional<String> refusal(FollowState state, FollowInput input) {
        return Refusals.of(state.stage(), input);
    }
}
