package org.dronemap.ws.lab;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.time.Time;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;

/** The frames that went over one wire, with their times: what reached the server, and what the server sent. */
public final class LinkFrameLog {
    private final Time time;
    private final List<Passed> frames = new ArrayList<>();
    private final FrameReader upward = new FrameReader();
    private final FrameReader downward = new FrameReader();

    /**
     * One frame on its way.
     *
     * @param nanos the laboratory's time
     * @param up to the server
     */
    public record Passed(long nanos, boolean up, Frame frame) {}

    LinkFrameLog(Time time) {
        this.time = time;
    }

    void add(boolean up, byte[] bytes) {
        (up ? upward : downward).read(ByteBuffer.wrap(bytes), frame -> frames.add(new Passed(time.nanos(), up, frame)));
    }

    /** In the order of time. */
    public List<Passed> frames(boolean up) {
        return frames.stream().filter(passed -> passed.up() == up).toList();
    }
}
