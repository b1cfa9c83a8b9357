package org.dronemap.cognitive.operation.follow;

import java.time.Instant;

/** Applies a user's request to the state of a follow. */
final class Wishes {
    private Wishes() {}

    static FollowState taken(FollowState state, FollowInput.Wish wish) {
        Instant at = wish.at();
        String by = wish.by();
        String name = state.order().chosen().name();
        if (wish instanceof FollowInput.Start) {
            return state.to(Stage.STARTING, at, by + " had " + name + " take off.");
        }
        if (wish instanceof FollowInput.Cancel) {
            return state.stage() == Stage.ALLOCATED
                    ? state.to(Stage.OVER, at, by + " cancelled it.")
                    : state.to(Stage.RETURNING, at, by + " cancelled it.");
        }
        if (wish instanceof FollowInput.Pause) {
            return state.to(Stage.PAUSED, at, by + " had " + name + " wait where it is.");
        }
        if (wish instanceof FollowInput.GoOn) {
            // One that is on the ground by now takes off again.
            return state.to(Stage.STARTING, at, by + " had " + name + " follow again.");
        }
        if (wish instanceof FollowInput.Change change) {
            return state.with(state.order().at(change.place()));
        }
        return state.stage() == Stage.SUSPENDED
                ? state.to(Stage.OVER, at, by + " stopped it; whoever has " + name + " keeps it.")
                : state.to(Stage.RETURNING, at, by + " called " + name + " home.");
    }
}
