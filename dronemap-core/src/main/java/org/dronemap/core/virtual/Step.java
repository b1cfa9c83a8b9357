package org.dronemap.core.virtual;

import org.dronemap.core.command.Command;
import org.jspecify.annotations.Nullable;

/**
 * Step of the run machine: next run, command to send, and release of the drone.
 *
 * @param send null: nothing
 */
public record Step(Run run, @Nullable Command send, Release release) {
    /** What becomes of control of the drone. */
    public enum Release {
        KEEP,
        /** Given back. */
        FREE,
        /** Kept until the drone is heard again, is called home, and is back. */
        RECALL
    }

    static Step stay(Run run) {
        return new Step(run, null, Release.KEEP);
    }

    static Step send(Run run, Command command) {
        return new Step(run, command, Release.KEEP);
    }

    static Step leave(Run run, Release release) {
        return new Step(run, null, release);
    }
}
