package org.dronemap.proxy.outlet;

import org.dronemap.core.command.Outcome;

/** Outcomes as MAVLink and people put them. */
final class Reasons {
    static final int ACCEPTED = 0;
    static final int TEMPORARILY_REJECTED = 1;
    static final int DENIED = 2;
    static final int UNSUPPORTED = 3;
    static final int FAILED = 4;
    static final int CANCELLED = 6;

    private Reasons() {}

    /** MAV_RESULT. */
    static int result(Outcome outcome) {
        if (outcome instanceof Outcome.Succeeded) {
            return ACCEPTED;
        }
        if (outcome instanceof Outcome.Refused refused) {
            return refused.by().equals("gate") ? DENIED : TEMPORARILY_REJECTED;
        }
        return outcome instanceof Outcome.Superseded ? CANCELLED : FAILED;
    }

    /** Why not; empty when it succeeded. */
    static String sentence(Outcome outcome) {
        if (outcome instanceof Outcome.Refused refused) {
            return refused.reason();
        }
        if (outcome instanceof Outcome.Failed failed) {
            return failed.reason();
        }
        if (outcome instanceof Outcome.TimedOut timedOut) {
            return timedOut.reason();
        }
        if (outcome instanceof Outcome.Superseded superseded) {
            return superseded.reason();
        }
        return outcome instanceof Outcome.Unknown unknown ? unknown.reason() : "";
    }
}
