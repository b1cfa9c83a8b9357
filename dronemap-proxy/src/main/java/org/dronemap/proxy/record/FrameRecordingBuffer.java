package org.dronemap.proxy.record;

import java.time.Clock;
import org.dronemap.core.cloud.SendAuthority;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.session.FrameTap;

/**
 * Buffers the MAVLink frames of one vehicle session for the recorder, and follows whether the vehicle is armed. Any
 * thread.
 */
final class FrameRecordingBuffer extends RecordingBuffer implements FrameTap {
    private static final int HALF_BYTES = 32_768;
    private static final int LONGEST = 512;
    private static final int ARMED = 128;

    private final int autopilot;

    FrameRecordingBuffer(Clock clock, BufferBudget room, int autopilot, boolean always) {
        super(clock, room, always, HALF_BYTES, LONGEST);
        this.autopilot = autopilot;
    }

    @Override
    public void received(Frame frame) {
        markReceived();
        if (frame.messageId() == Heartbeat.ID && frame.componentId() == autopilot && frame.verified()) {
            arming((Heartbeat.decode(frame).baseMode() & ARMED) != 0);
        }
        keep(frame.length(), (stretch, now) -> stretch.addReceived(now, frame));
    }

    @Override
    public void sent(byte[] frame, SendAuthority mandate) {
        keep(frame.length, (stretch, now) -> stretch.addSent(now, frame, mandate));
    }

    @Override
    String ending() {
        return RecordingFiles.FRAMES;
    }
}
