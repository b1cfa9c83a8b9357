package org.dronemap.proxy.mavlink.procedure;

import org.dronemap.core.command.Outcome;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.jspecify.annotations.Nullable;

/** Sends a place to fly to as a position target, three times, since a vehicle never acknowledges it. */
public final class PositionTargetExchange implements Exchange {
    private static final int TIMES = 3;
    private static final long BETWEEN_NANOS = 300_000_000L;
    /** Only latitude, longitude and altitude count. */
    private static final int POSITION_ONLY = 0x0DF8;

    private final MavlinkTarget target;
    private final CommandInt place;
    private int sent;
    private long lastSentNanos;
    private @Nullable Outcome outcome;

    /** {@code place}: the repositioning that it stands in for. */
    public PositionTargetExchange(MavlinkTarget target, CommandInt place) {
        this.target = target;
        this.place = place;
    }

    @Override
    public void start(long nowNanos) {
        send(nowNanos);
    }

    @Override
    public void received(Frame frame, long nowNanos) {}

    @Override
    public void advance(long nowNanos) {
        if (outcome == null && nowNanos - lastSentNanos >= BETWEEN_NANOS) {
            if (sent == TIMES) {
                outcome = new Outcome.Succeeded();
            } else {
                send(nowNanos);
            }
        }
    }

    private void send(long nowNanos) {
        target.send(new SetPositionTargetGlobalInt(
                0,
                target.systemId(),
                target.componentId(),
                place.frame(),
                POSITION_ONLY,
                place.x(),
                place.y(),
                place.z(),
                0f,
                0f,
                0f,
                0f,
                0f,
                0f,
                0f,
                0f));
        sent++;
        lastSentNanos = nowNanos;
    }

    @Override
    public @Nullable Outcome outcome() {
        return outcome;
    }
}
