package org.dronemap.proxy.mavlink.procedure;

import org.dronemap.core.command.Outcome;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionClearAll;
import org.jspecify.annotations.Nullable;

/** Asks a vehicle to delete its mission, fence or rally points; a read-back has to confirm it. */
public final class MissionClear implements Exchange {
    private static final long LEAST_PAUSE_NANOS = 500_000_000L;

    private final MavlinkTarget target;
    private final MavMissionType kind;
    private final TransferTimeout patience = new TransferTimeout();
    private int tries;
    private long lastSentNanos;
    private @Nullable Outcome outcome;

    public MissionClear(MavlinkTarget target, MavMissionType kind) {
        this.target = target;
        this.kind = kind;
    }

    @Override
    public void start(long nowNanos) {
        patience.begin(nowNanos);
        send(nowNanos);
    }

    @Override
    public void received(Frame frame, long nowNanos) {
        patience.received(nowNanos);
        if (outcome == null && frame.messageId() == MissionAck.ID) {
            MissionAck ack = MissionAck.decode(frame);
            if (ack.missionType() == kind.number() && MavlinkTarget.isForUs(ack.targetSystem())) {
                outcome = ack.type() == MavMissionResult.ACCEPTED
                        ? new Outcome.Succeeded()
                        : new Outcome.Refused("vehicle", MavMissionResult.refusal(ack.type()));
            }
        }
    }

    @Override
    public void advance(long nowNanos) {
        if (outcome == null && nowNanos - lastSentNanos >= pauseNanos()) {
            outcome = patience.end(nowNanos);
            if (outcome == null) {
                send(nowNanos);
            }
        }
    }

    private void send(long nowNanos) {
        target.send(new MissionClearAll(target.systemId(), target.componentId(), kind.number()));
        patience.asked(nowNanos);
        tries++;
        lastSentNanos = nowNanos;
    }

    /** As the link is now: a long transfer may begin on a good one and go on over a bad one. */
    private long pauseNanos() {
        return Math.max(
                LEAST_PAUSE_NANOS, RetrySchedule.of(target.roundTrip(), 0).pauseNanos(tries));
    }

    @Override
    public @Nullable Outcome outcome() {
        return outcome;
    }
}
