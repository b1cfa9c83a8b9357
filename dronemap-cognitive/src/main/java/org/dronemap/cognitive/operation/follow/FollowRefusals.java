package org.dronemap.cognitive.operation.follow;

import java.util.Optional;
import org.dronemap.core.operation.ChosenDrone;
import org.dronemap.core.operation.Objection;

/** Decides whether a user's request to a follow is refused at its present stage, and for which reason. */
final class FollowRefusals {
    private FollowRefusals() {}

    static Optional<Objection> of(FollowState state, FollowInput input) {
        if (input instanceof FollowInput.SendRelief relieve) {
            return relieve(state, relieve.chosen());
        }
        FollowStage stage = state.stage();
        boolean ends = input instanceof FollowInput.Stop || input instanceof FollowInput.Cancel;
        if (ends && stage == FollowStage.RETURNING && (state.reliefOrNone().vacant() || state.isRelieved())) {
            // Whoever comes in its place is called off.
            return Optional.empty();
        }
        return of(stage, input);
    }

    private static Optional<Objection> of(FollowStage stage, FollowInput input) {
        if (input instanceof FollowInput.Start) {
            return start(stage);
        }
        if (input instanceof FollowInput.Cancel) {
            return cancel(stage);
        }
        if (input instanceof FollowInput.Pause) {
            return pause(stage);
        }
        if (input instanceof FollowInput.Resume) {
            return goOn(stage);
        }
        if (input instanceof FollowInput.Stop) {
            return stop(stage);
        }
        return input instanceof FollowInput.ChangePlace && stage == FollowStage.RETURNING ? home() : Optional.empty();
    }

    private static Optional<Objection> relieve(FollowState state, ChosenDrone chosen) {
        boolean known = state.drone().equals(chosen.drone())
                || state.reliefOrNone().others().stream()
                        .anyMatch(other -> other.drone().equals(chosen.drone()));
        if (state.isRelievable() && !known) {
            return Optional.empty();
        }
        return why(
                state.isRelievable() ? FollowObjection.HAS_DRONE : FollowObjection.NOT_RELIEVABLE,
                "Nobody has to replace " + state.droneName() + " now.");
    }

    private static Optional<Objection> start(FollowStage stage) {
        return switch (stage) {
            case ALLOCATED, OVER -> Optional.empty();
            case STARTING -> why(FollowObjection.STARTING, "The drone is taking off already.");
            case TRACKING -> why(FollowObjection.STARTED, "The drone follows already.");
            case PAUSED -> why(FollowObjection.PAUSED, "It has been started; let it go on.");
            case SUSPENDED -> why(FollowObjection.SUSPENDED, "It has been started; let it go on.");
            case RETURNING -> home();
        };
    }

    private static Optional<Objection> cancel(FollowStage stage) {
        return switch (stage) {
            case ALLOCATED, STARTING, OVER -> Optional.empty();
            case TRACKING, PAUSED, SUSPENDED -> why(FollowObjection.STARTED, "It follows already; stop it instead.");
            case RETURNING -> home();
        };
    }

    private static Optional<Objection> pause(FollowStage stage) {
        return switch (stage) {
            case TRACKING, OVER -> Optional.empty();
            case ALLOCATED -> notStarted();
            case STARTING ->
                why(FollowObjection.STARTING, "The drone is taking off; pause it when it follows, or cancel it.");
            case PAUSED -> why(FollowObjection.PAUSED, "It is paused already.");
            case SUSPENDED -> why(FollowObjection.SUSPENDED, "Somebody else has the drone: it does not follow.");
            case RETURNING -> home();
        };
    }

    private static Optional<Objection> goOn(FollowStage stage) {
        return switch (stage) {
            case PAUSED, SUSPENDED, OVER -> Optional.empty();
            case ALLOCATED -> notStarted();
            case STARTING -> why(FollowObjection.STARTING, "The drone is taking off; it follows as soon as it is up.");
            case TRACKING -> why(FollowObjection.NOT_PAUSED, "It is not paused.");
            case RETURNING -> home();
        };
    }

    private static Optional<Objection> stop(FollowStage stage) {
        return switch (stage) {
            case STARTING, TRACKING, PAUSED, SUSPENDED, OVER -> Optional.empty();
            case ALLOCATED -> notStarted();
            case RETURNING -> home();
        };
    }

    private static Optional<Objection> home() {
        return why(FollowObjection.RETURNING, "The drone is on its way home already.");
    }

    private static Optional<Objection> notStarted() {
        return why(FollowObjection.NOT_STARTED, "It has not been started: start it, or cancel it.");
    }

    private static Optional<Objection> why(FollowObjection code, String sentence) {
        return Optional.of(Objection.of(code, sentence));
    }
}
