package org.dronemap.core.virtual;

import org.dronemap.core.command.Command;
import org.jspecify.annotations.Nullable;

/**
 * Output of VirtualRunMachine: the next state of the run, a command to send, and what becomes of control.
 *
 * @param send null: nothing
 */
public record VirtualRunStep(VirtualRun run, @Nullable Command send, Release release) {
    /** Effect of a step on control of the drone: keep, release, or keep until it is recalled and back. */
    public enum Release {
        KEEP,
        /** Given back. */
        FREE,
        /** Kept until the drone is heard again, is called home, and is back. */
        RECALL
    }

    static VirtualRunStep unchanged(VirtualRun run) {
        return new VirtualRunStep(run, null, Release.KEEP);
    }

    static VirtualRunStep send(VirtualRun run, Command command) {
        return new VirtualRunStep(run, command, Release.KEEP);
    }

    static VirtualRunStep leave(VirtualRun run, Release release) {
        return new VirtualRunStep(run, null, release);
    }
}
