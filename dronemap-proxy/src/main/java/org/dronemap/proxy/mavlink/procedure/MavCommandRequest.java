package org.dronemap.proxy.mavlink.procedure;

import java.time.Duration;
import java.util.function.BooleanSupplier;
import java.util.function.IntFunction;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.CommandLong;

/**
 * One MAV_CMD to be sent to a vehicle, with its retry class and how its completion is recognised.
 *
 * @param message the message for the given confirmation count
 * @param command the MAV_CMD that the acknowledgement names
 * @param retry whether it may be sent again without a look at the vehicle
 * @param proof when it is seen to be done
 */
public record MavCommandRequest(IntFunction<Message> message, int command, Retry retry, CompletionCheck proof) {
    /** The retry class of a command: what may happen between two tries. */
    public enum Retry {
        /** Doing it twice is doing it once. */
        REPEATABLE,
        /** Sent again only after a sign of the vehicle that does not show it done. */
        VERIFY_FIRST,
        /** Never sent again: twice would be once too often. */
        ONCE
    }

    /**
     * {@code seen} shows that it came about, within {@code patience} of the acceptance; else {@code unseen} is said.
     *
     * @param shownBy the message that would show it, so that nothing is said before one came; {@link #ANY}: none in particular
     */
    public record CompletionCheck(BooleanSupplier seen, Duration patience, String unseen, int shownBy) {
        public static final int ANY = -1;

        /** The acknowledgement is all that will be heard. */
        public static final CompletionCheck ACKNOWLEDGED = new CompletionCheck(() -> true, Duration.ZERO, "", ANY);
    }

    /** Parameters of a COMMAND_LONG, the missing ones 0. */
    public static MavCommandRequest ofLong(
            MavlinkTarget target, int command, float[] parameters, Retry retry, CompletionCheck proof) {
        float[] p = java.util.Arrays.copyOf(parameters, 7);
        return new MavCommandRequest(
                confirmation -> new CommandLong(
                        target.systemId(),
                        target.componentId(),
                        command,
                        confirmation,
                        p[0],
                        p[1],
                        p[2],
                        p[3],
                        p[4],
                        p[5],
                        p[6]),
                command,
                retry,
                proof);
    }

    /** A COMMAND_INT, whose position is exact. */
    public static MavCommandRequest ofInt(CommandInt message, Retry retry) {
        return new MavCommandRequest(confirmation -> message, message.command(), retry, CompletionCheck.ACKNOWLEDGED);
    }
}
