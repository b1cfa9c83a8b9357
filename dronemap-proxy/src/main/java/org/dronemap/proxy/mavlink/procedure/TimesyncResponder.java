package org.dronemap.proxy.mavlink.procedure;

import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.Timesync;

/** Answers the TIMESYNC requests of a vehicle with the server's monotonic time. Owned by the session's lane. */
public final class TimesyncResponder {
    /** Who asks more often than this is not after the time. */
    private static final long BETWEEN_NANOS = 20_000_000L;

    private final MavlinkTarget target;
    private boolean answered;
    private long lastAnswerNanos;

    public TimesyncResponder(MavlinkTarget target) {
        this.target = target;
    }

    /** Any frame of a vehicle that is known. */
    public void received(Frame frame, long nowNanos) {
        if (frame.messageId() != Timesync.ID) {
            return;
        }
        Timesync question = Timesync.decode(frame);
        boolean tooSoon = answered && nowNanos - lastAnswerNanos < BETWEEN_NANOS;
        if (question.tc1() != 0 || !MavlinkTarget.isForUs(question.targetSystem()) || tooSoon) {
            return;
        }
        answered = true;
        lastAnswerNanos = nowNanos;
        target.send(new Timesync(nowNanos, question.ts1(), target.systemId(), target.componentId()));
    }
}
