package org.dronemap.proxy.mavlink.procedure;

import org.dronemap.core.command.Outcome;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionClearAll;
import org.jspecify.annotations.Nullable;

/** Asks a vehicle to forget its mission; whether it did is for a read-back to say. */
public final class MissionClear implements Exchange {
    private static final int TRIES = 9;
    private static final long BETWEEN_TRIES_NANOS = 700_000_000L;

    private final Target target;
    private int tries;
    private long lastSentNanos;
    private @Nullable Outcome outcome;

    public MissionClear(Target target) {
        this.target = target;
    }

    @Override
    public void start(long nowNanos) {
        send(nowNanos);
    }

    @Override
    public void heard(Frame frame, long nowNanos) {
        if (outcome == null && frame.messageId() == MissionAck.ID) {
            MissionAck ack = MissionAck.decode(frame);
            if (ack.missionType() == 0 && Target.isForUs(ack.targetSystem())) {
                outcome = ack.type() == MissionResult.ACCEPTED
                        ? new Outcome.Succeeded()
                        : new Outcome.Refused("vehicle", MissionResult.words(ack.type()));
            }
        }
    }

    @Override
    public void tick(long nowNanos) {
        if (outcome == null && nowNanos - lastSentNanos >= BETWEEN_TRIES_NANOS) {
            if (tries == TRIES) {
                outcome = CommandExchange.noAnswer(TRIES * BETWEEN_TRIES_NANOS, TRIES);
            } else {
                send(nowNanos);
            }
        }
    }

    private void send(long nowNanos) {
        target.send(new MissionClearAll(target.systemId(), target.componentId(), 0));
        tries++;
        lastSentNanos = nowNanos;
    }

    @Override
    public @Nullable Outcome outcome() {
        return outcome;
    }
}
