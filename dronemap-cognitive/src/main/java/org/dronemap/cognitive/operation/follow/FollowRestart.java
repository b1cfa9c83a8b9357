package org.dronemap.cognitive.operation.follow;

import java.time.Duration;
import java.time.Instant;
import org.dronemap.cognitive.operation.follow.FollowInput.Observation;
import org.dronemap.cognitive.operation.follow.FollowInput.Observed;

/** Decides how a follow goes on after the server was restarted. */
final class FollowRestart {
    private FollowRestart() {}

    /** The process was started again: what the phone says is heard anew. */
    static FollowState restarted(FollowState state, Instant at) {
        boolean late =
                Duration.between(state.since(), at).toSeconds() > state.order().patienceSeconds();
        if (state.stage() == FollowStage.STARTING && late) {
            // Nobody who pressed a button long ago expects motors to start now.
            return state.to(
                    FollowStage.RETURNING,
                    at,
                    "The server was stopped while " + state.order().chosen().name()
                            + " took off, and came back too late; it flies home.");
        }
        return state.waiting(at);
    }

    /** Since it came to this stage the process was started again, and the phone has not been heard beside its drone yet. */
    static boolean isRecent(FollowState state) {
        return state.waitsSince().isAfter(state.since());
    }

    private static boolean hasReported(FollowState state, Observed looked) {
        return looked.lastReport() != null && !looked.lastReport().isBefore(state.waitsSince());
    }

    /** It waits for nothing any more that has to do with a restart. */
    static FollowState withoutRestart(FollowState state, Observed looked) {
        return isRecent(state) && hasReported(state, looked) ? state.waiting(state.since()) : state;
    }

    /** In a mode in which it is not led: vehicles that miss the cloud come home, and can be led again. */
    static FollowState returning(FollowState state, Observed looked, Observation look) {
        Instant at = looked.at();
        String name = state.order().chosen().name();
        String mode = String.valueOf(look.mode());
        // Who lands where it is has other reasons.
        boolean missed = isRecent(state) && look.modes() != null && look.modes().home();
        if (missed && state.stage() == FollowStage.TRACKING) {
            if (hasReported(state, looked)) {
                return state.to(
                        FollowStage.STARTING, at, name + " came home since it had missed the cloud; it follows again.");
            }
            if (Duration.between(state.waitsSince(), at).toSeconds()
                    < state.order().patienceSeconds()) {
                return state.noted(name + " comes home since it missed the cloud; it follows again as soon as the phone"
                        + " says where it is.");
            }
        }
        return state.to(
                FollowStage.RETURNING,
                at,
                missed
                        ? name + " comes home since it missed the cloud."
                        : name + " went into " + mode + "; it flies home.");
    }
}
