package org.dronemap.cognitive.operation.follow;

import java.util.Optional;

/** Why a wish cannot be taken at a stage. */
final class Refusals {
    private static final String HOME = "The drone is on its way home already.";
    private static final String NOT_STARTED = "It has not been started: start it, or cancel it.";

    private Refusals() {}

    static Optional<String> of(FollowState state, FollowInput input) {
        if (input instanceof FollowInput.Relieve relieve) {
            return relieve(state, relieve.chosen());
        }
        Stage stage = state.stage();
        boolean ends = input instanceof FollowInput.Stop || input instanceof FollowInput.Cancel;
        if (ends && stage == Stage.RETURNING && (state.crew().vacant() || state.isRelieved())) {
            // Whoever comes in its place is called off.
            return Optional.empty();
        }
        return of(stage, input);
    }

    private static Optional<String> of(Stage stage, FollowInput input) {
        if (input instanceof FollowInput.Start) {
            return start(stage);
        }
        if (input instanceof FollowInput.Cancel) {
            return cancel(stage);
        }
        if (input instanceof FollowInput.Pause) {
            return pause(stage);
        }
        if (input instanceof FollowInput.GoOn) {
            return goOn(stage);
        }
        if (input instanceof FollowInput.Stop) {
            return stop(stage);
        }
        return input instanceof FollowInput.Change && stage == Stage.RETURNING ? Optional.of(HOME) : Optional.empty();
    }

    private static Optional<String> relieve(FollowState state, FollowOrder.Chosen chosen) {
        boolean known = state.drone().equals(chosen.drone())
                || state.crew().others().stream()
                        .anyMatch(other -> other.drone().equals(chosen.drone()));
        return state.isRelievable() && !known
                ? Optional.empty()
                : Optional.of("Nobody has to replace " + state.droneName() + " now.");
    }

    private static Optional<String> start(Stage stage) {
        return switch (stage) {
            case ALLOCATED, OVER -> Optional.empty();
            case STARTING -> Optional.of("The drone is taking off already.");
            case TRACKING -> Optional.of("The drone follows already.");
            case PAUSED, SUSPENDED -> Optional.of("It has been started; let it go on.");
            case RETURNING -> Optional.of(HOME);
        };
    }

    private static Optional<String> cancel(Stage stage) {
        return switch (stage) {
            case ALLOCATED, STARTING, OVER -> Optional.empty();
            case TRACKING, PAUSED, SUSPENDED -> Optional.of("It follows already; stop it instead.");
            case RETURNING -> Optional.of(HOME);
        };
    }

    private static Optional<String> pause(Stage stage) {
        return switch (stage) {
            case TRACKING, OVER -> Optional.empty();
            case ALLOCATED -> Optional.of(NOT_STARTED);
            case STARTING -> Optional.of("The drone is taking off; pause it when it follows, or cancel it.");
            case PAUSED -> Optional.of("It is paused already.");
            case SUSPENDED -> Optional.of("Somebody else has the drone: it does not follow.");
            case RETURNING -> Optional.of(HOME);
        };
    }

    private static Optional<String> goOn(Stage stage) {
        return switch (stage) {
            case PAUSED, SUSPENDED, OVER -> Optional.empty();
            case ALLOCATED -> Optional.of(NOT_STARTED);
            case STARTING -> Optional.of("The drone is taking off; it follows as soon as it is up.");
            case TRACKING -> Optional.of("It is not paused.");
            case RETURNING -> Optional.of(HOME);
        };
    }

    private static Optional<String> stop(Stage stage) {
        return switch (stage) {
            case STARTING, TRACKING, PAUSED, SUSPENDED, OVER -> Optional.empty();
            case ALLOCATED -> Optional.of(NOT_STARTED);
            case RETURNING -> Optional.of(HOME);
        };
    }
}
