package org.dronemap.proxy.outlet.uplink;

import org.dronemap.core.command.Outcome;

/** Translates the outcomes of commands into MAV_RESULT and a sentence for ground stations at the outlet. */
final class OutcomeTranslator {
    static final int ACCEPTED = 0;
    static final int TEMPORARILY_REJECTED = 1;
    static final int DENIED = 2;
    static final int UNSUPPORTED = 3;
    static final int FAILED = 4;
    static final int CANCELLED = 6;

    private OutcomeTranslator() {}

    /** MAV_RESULT. */
    static int result(Outcome outcome) {
        return switch (outcome.kind()) {
            case SUCCEEDED -> ACCEPTED;
            case REFUSED -> "gate".equals(outcome.by()) ? DENIED : TEMPORARILY_REJECTED;
            case SUPERSEDED -> CANCELLED;
            case FAILED, TIMED_OUT, UNKNOWN -> FAILED;
        };
    }

    /** Why not; empty when it succeeded. */
    static String sentence(Outcome outcome) {
        String why = outcome.reason();
        return why == null ? "" : why;
    }
}
