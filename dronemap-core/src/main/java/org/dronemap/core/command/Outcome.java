package org.dronemap.core.command;

import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/** The outcome of a command: succeeded, refused, failed, timed out, superseded or unknown. */
public sealed interface Outcome {
    /** Kinds of outcomes; used in switches without a default, so that a missing case does not compile. */
    enum Kind {
        SUCCEEDED("succeeded"),
        REFUSED("refused"),
        FAILED("failed"),
        TIMED_OUT("timedOut"),
        SUPERSEDED("superseded"),
        UNKNOWN("unknown");

        private final String word;

        Kind(String word) {
            this.word = word;
        }

        /** For ever: clients read it, and it is stored. */
        public String word() {
            return word;
        }
    }

    Kind kind();

    /** Who said no: "gate" or "vehicle"; null unless somebody did. */
    default @Nullable String by() {
        return null;
    }

    /** Why it did not succeed, as a sentence; null when it did. */
    @Nullable
    String reason();

    /** The same as a word for programs; null when it did. */
    default @Nullable OutcomeCode code() {
        return switch (kind()) {
            case SUCCEEDED -> null;
            case REFUSED -> OutcomeCode.COMMAND_REFUSED;
            case FAILED -> OutcomeCode.COMMAND_FAILED;
            case TIMED_OUT -> OutcomeCode.COMMAND_TIMED_OUT;
            case SUPERSEDED -> OutcomeCode.COMMAND_SUPERSEDED;
            case UNKNOWN -> OutcomeCode.OUTCOME_UNKNOWN;
        };
    }

    /** Carried out, and seen to be. */
    @Stored(as = "Succeeded")
    record Succeeded() implements Outcome {
        @Override
        public Kind kind() {
            return Kind.SUCCEEDED;
        }

        @Override
        public @Nullable String reason() {
            return null;
        }
    }

    /**
     * Somebody said no before it had an effect; {@code by} is "gate" or "vehicle".
     *
     * @param cause null: an earlier version wrote it down
     */
    @Stored(as = "Refused", names = "by reason code", later = "code")
    record Refused(
            @Override String by,
            @Override String reason,
            @Nullable OutcomeCode cause) implements Outcome {
        public Refused(String by, Refusal why) {
            this(by, why.sentence(), why.code());
        }

        @Override
        public OutcomeCode code() {
            if (cause != null) {
                return cause;
            }
            return by.equals("vehicle") ? OutcomeCode.VEHICLE_REFUSED : OutcomeCode.COMMAND_REFUSED;
        }

        @Override
        public Kind kind() {
            return Kind.REFUSED;
        }
    }

    /** Accepted, but it did not come about. */
    @Stored(as = "Failed", names = "reason")
    record Failed(@Override String reason) implements Outcome {
        @Override
        public Kind kind() {
            return Kind.FAILED;
        }
    }

    /** No answer within the stated time; {@code reason} states it. */
    @Stored(as = "TimedOut", names = "reason")
    record TimedOut(@Override String reason) implements Outcome {
        @Override
        public Kind kind() {
            return Kind.TIMED_OUT;
        }
    }

    /** A newer command took its place. */
    @Stored(as = "Superseded", names = "reason")
    record Superseded(@Override String reason) implements Outcome {
        @Override
        public Kind kind() {
            return Kind.SUPERSEDED;
        }
    }

    /** It may or may not have acted, and nobody can tell any more. */
    @Stored(as = "Unknown", names = "reason")
    record Unknown(@Override String reason) implements Outcome {
        @Override
        public Kind kind() {
            return Kind.UNKNOWN;
        }
    }
}
