package org.dronemap.cognitive.operation.follow;

import java.time.Duration;
import java.time.Instant;
import org.dronemap.cognitive.operation.follow.FollowInput.ControlRestriction;
import org.dronemap.cognitive.operation.follow.FollowInput.Observation;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.operation.OperationObservation;
import org.jspecify.annotations.Nullable;

/** Checks who controls a drone of a follow, and decides what the follow does without control. */
final class FollowControlCheck {
    private FollowControlCheck() {}

    static @Nullable ControlRestriction of(
            DroneState drone, OperationObservation.ControlStatus sway, @Nullable Steering steering) {
        boolean waits = steering != null && steering.acceptsCommands() && Boolean.TRUE.equals(drone.armed());
        ControlRestriction grip =
                new ControlRestriction(sway.whyNotAllowed(), sway.free() && waits, steering == Steering.STICKS);
        return grip.commandRefusal() == null && !grip.withoutHolder() && !grip.steered() ? null : grip;
    }

    /** Not zero either while a vehicle has not said how it is since the process began. */
    static int silentSeconds(DroneState drone, Duration silence) {
        boolean unknown = drone.link().state() == LinkState.LOST
                || drone.mode() == null
                || drone.armed() == null
                || (drone.phase() == null && drone.position() == null);
        return Math.max(unknown ? 1 : 0, (int) silence.toSeconds());
    }

    static boolean isRefused(FollowState state, Observation look) {
        ControlRestriction grip = look.restriction();
        return grip != null
                && grip.commandRefusal() != null
                && state.stage().holds()
                && state.stage() != FollowStage.RETURNING;
    }

    /** Nobody else has the drone: it is brought home, as the last that is done for whoever asked. */
    static FollowState returnOnRefusal(FollowState state, Observation look, Instant at) {
        String why = look.restriction() == null
                ? ""
                : String.valueOf(look.restriction().commandRefusal());
        return state.stage() == FollowStage.ALLOCATED
                ? state.to(FollowStage.OVER, at, why)
                : state.to(
                        FollowStage.RETURNING,
                        at,
                        why + " " + state.order().chosen().name() + " flies home.");
    }

    /** A pilot flies it whom nobody has seen take it: soon after a command, or while the process did not run. */
    static boolean isUnderPilot(FollowState state, Observation look) {
        ControlRestriction grip = look.restriction();
        boolean steered = grip != null && grip.steered() && look.airborne();
        return switch (state.stage()) {
            case TRACKING, PAUSED, RETURNING -> steered;
            // One that is taken back from its pilot on purpose is in such a mode as well.
            case STARTING -> steered && FollowRestart.isRecent(state);
            case ALLOCATED, SUSPENDED, OVER -> false;
        };
    }

    /** Left to whoever has the drone; when nobody has it any more, it waits for somebody, and is brought home then. */
    static FollowState suspended(FollowState state, Observation look, Instant at) {
        String name = state.order().chosen().name();
        if (!look.armed()) {
            return state.to(FollowStage.OVER, at, name + " is down" + FollowCommands.IT_IS_OVER);
        }
        int patience = state.order().patienceSeconds();
        String words = "Nobody has " + name + " any more; if nobody takes it, it flies home after " + patience + " s.";
        if (look.restriction() == null || !look.restriction().withoutHolder()) {
            return state.noted(null);
        }
        if (!words.equals(state.note())) {
            return state.waiting(at).noted(words);
        }
        return Duration.between(state.waitsSince(), at).toSeconds() < patience
                ? state
                : state.to(
                        FollowStage.RETURNING,
                        at,
                        "Nobody has had " + name + " for " + patience + " s; it flies home.");
    }
}
