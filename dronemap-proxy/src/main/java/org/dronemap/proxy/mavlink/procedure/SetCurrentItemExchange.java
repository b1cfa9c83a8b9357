package org.dronemap.proxy.mavlink.procedure;

import java.util.function.IntPredicate;
import org.dronemap.core.command.Outcome;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.MissionCurrent;
import org.dronemap.mavlink.message.MissionSetCurrent;
import org.jspecify.annotations.Nullable;

/** Makes a vehicle continue its mission at a given item, and waits until its MISSION_CURRENT shows it. */
public final class SetCurrentItemExchange implements Exchange {
    private static final int TRIES = 4;
    private static final long BETWEEN_TRIES_NANOS = 500_000_000L;

    private final MavlinkTarget target;
    private final int seq;
    private final IntPredicate seen;
    private int tries;
    private long lastSentNanos;
    private @Nullable Outcome outcome;

    /** {@code seq} counts as on the wire. */
    public SetCurrentItemExchange(MavlinkTarget target, int seq, IntPredicate seen) {
        this.target = target;
        this.seq = seq;
        this.seen = seen;
    }

    @Override
    public void start(long nowNanos) {
        send(nowNanos);
    }

    @Override
    public void received(Frame frame, long nowNanos) {
        if (frame.messageId() == MissionCurrent.ID
                && seen.test(MissionCurrent.decode(frame).seq())) {
            outcome = new Outcome.Succeeded();
        }
    }

    @Override
    public void advance(long nowNanos) {
        if (outcome == null && nowNanos - lastSentNanos >= BETWEEN_TRIES_NANOS) {
            if (tries == TRIES) {
                outcome = CommandExchange.noAnswer(TRIES * BETWEEN_TRIES_NANOS, TRIES);
            } else {
                send(nowNanos);
            }
        }
    }

    private void send(long nowNanos) {
        target.send(new MissionSetCurrent(target.systemId(), target.componentId(), seq));
        tries++;
        lastSentNanos = nowNanos;
    }

    @Override
    public @Nullable Outcome outcome() {
        return outcome;
    }
}
