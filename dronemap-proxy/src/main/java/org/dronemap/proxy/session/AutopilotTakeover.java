package org.dronemap.proxy.session;

import java.util.ArrayDeque;
import java.util.Queue;
import java.util.function.Predicate;
import org.dronemap.core.cloud.SendAuthority;
import org.dronemap.core.cloud.VehicleChannel;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.jspecify.annotations.Nullable;

/**
 * The time in which another component of a session's vehicle takes over as the autopilot: commands given meanwhile wait for
 * the session of that one; nothing of them was sent. Owned by the drone's lane, but for its beginning.
 */
final class AutopilotTakeover {
    /** Longer nobody waits for it: what comes late surprises. */
    private static final long LONGEST_NANOS = 5_000_000_000L;

    private static final String NOT_SENT =
            "It was not sent: another component of the vehicle was just taking over as its"
                    + " autopilot. Give it again.";

    private static final String NOT_THE_AUTOPILOT =
            "It went to another component of the vehicle, which had not answered"
                    + " when the autopilot was heard; look at the drone.";

    private volatile @Nullable VehicleSession successor;
    private final Queue<WaitingCommand> waiting = new ArrayDeque<>();

    private record WaitingCommand(
            SendAuthority mandate, Command command, VehicleChannel.Report report, long sinceNanos) {}

    /** That session will speak for the drone. Any thread. */
    void begin(@Nullable VehicleSession autopilot) {
        successor = autopilot;
    }

    /** False when it has not begun: the command is the session's own. */
    boolean keeps(SendAuthority mandate, Command command, VehicleChannel.Report report, long nowNanos) {
        return successor != null && waiting.add(new WaitingCommand(mandate, command, report, nowNanos));
    }

    /** Why it is not known what becomes of what was sent before; {@code usual}: where nobody takes over. */
    String why(String usual) {
        return successor == null ? usual : NOT_THE_AUTOPILOT;
    }

    void cancel(CommandId id) {
        waiting.removeIf(one -> id.equals(one.mandate().command()));
    }

    /** Ends those that have waited too long. */
    void advance(long nowNanos) {
        while (!waiting.isEmpty() && nowNanos - waiting.element().sinceNanos() > LONGEST_NANOS) {
            waiting.remove().report().ended(new Outcome.Failed(NOT_SENT));
        }
    }

    /** {@code speaks}: whether that session speaks for the same drone now; they have failed where it does not. */
    void end(Predicate<VehicleSession> speaks) {
        VehicleSession next = successor;
        boolean taken = next != null && speaks.test(next);
        while (!waiting.isEmpty()) {
            WaitingCommand one = waiting.remove();
            if (next != null && taken) {
                next.perform(one.mandate(), one.command(), one.report());
            } else {
                one.report().ended(new Outcome.Failed(NOT_SENT));
            }
        }
    }
}
