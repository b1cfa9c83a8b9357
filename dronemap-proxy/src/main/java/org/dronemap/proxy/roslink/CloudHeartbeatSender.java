package org.dronemap.proxy.roslink;

import java.util.function.Consumer;
import org.dronemap.proxy.roslink.wire.RobotOrder;

/**
 * Sends the server's heartbeat to one robot once a second, as ROSLink asks for, so that no fail-safe trips. It goes by
 * the ticks of the robot's lane and by nothing else, so that it ends with whatever else the robot would be told.
 * Without I/O; owned by the session's lane.
 */
final class CloudHeartbeatSender {
    private static final long BETWEEN_NANOS = 1_000_000_000L;
    private static final RobotOrder HEARTBEAT = new RobotOrder.Heartbeat();

    private final Consumer<RobotOrder> send;
    private boolean begun;
    private long sentNanos;

    CloudHeartbeatSender(Consumer<RobotOrder> send) {
        this.send = send;
    }

    /** What was left out while the lane stood still is not made up for. */
    void sendDue(long nowNanos) {
        if (!begun || nowNanos - sentNanos >= BETWEEN_NANOS) {
            begun = true;
            sentNanos = nowNanos;
            send.accept(HEARTBEAT);
        }
    }
}
