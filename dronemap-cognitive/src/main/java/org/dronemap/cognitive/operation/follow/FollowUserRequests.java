package org.dronemap.cognitive.operation.follow;

import java.time.Instant;

/** Applies a user's request, such as pause, resume or stop, to the state of a follow. */
final class FollowUserRequests {
    private FollowUserRequests() {}

    static FollowState apply(FollowState state, FollowInput.UserRequest wish) {
        Instant at = wish.at();
        String by = wish.by();
        String name = state.order().chosen().name();
        if (wish instanceof FollowInput.Start) {
            return state.to(FollowStage.STARTING, at, by + " had " + name + " take off.");
        }
        if (wish instanceof FollowInput.Cancel) {
            return state.stage() == FollowStage.ALLOCATED
                    ? state.to(FollowStage.OVER, at, by + " cancelled it.")
                    : state.to(FollowStage.RETURNING, at, by + " cancelled it.");
        }
        if (wish instanceof FollowInput.Pause) {
            return state.to(FollowStage.PAUSED, at, by + " had " + name + " wait where it is.");
        }
        if (wish instanceof FollowInput.Resume) {
            // One that is on the ground by now takes off again.
            return state.to(FollowStage.STARTING, at, by + " had " + name + " follow again.");
        }
        if (wish instanceof FollowInput.ChangePlace change) {
            return state.with(state.order().at(change.place()));
        }
        return state.stage() == FollowStage.SUSPENDED
                ? state.to(FollowStage.OVER, at, by + " stopped it; whoever has " + name + " keeps it.")
                : state.to(FollowStage.RETURNING, at, by + " called " + name + " home.");
    }
}
