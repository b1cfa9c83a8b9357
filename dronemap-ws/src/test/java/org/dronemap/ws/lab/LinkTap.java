package org.dronemap.ws.lab;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.LongSupplier;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;

/** Hears all that is said at both ends of one wire, whether it arrives or not. */
public final class LinkTap {
    private final LongSupplier nanos;
    private final FrameReader upwards = new FrameReader();
    private final FrameReader downwards = new FrameReader();
    private final List<Heard> heard = new ArrayList<>();

    /**
     * One frame.
     *
     * @param up from the vehicle to the server
     */
    public record Heard(long nanos, boolean up, Frame frame) {}

    LinkTap(LongSupplier nanos) {
        this.nanos = nanos;
    }

    void said(byte[] bytes) {
        upwards.readDatagram(ByteBuffer.wrap(bytes), frame -> heard.add(new Heard(nanos.getAsLong(), true, frame)));
    }

    void told(byte[] bytes) {
        downwards.readDatagram(ByteBuffer.wrap(bytes), frame -> heard.add(new Heard(nanos.getAsLong(), false, frame)));
    }

    /** Everything in its order. */
    public List<Heard> all() {
        return List.copyOf(heard);
    }

    /** What the vehicle said of that kind. */
    public <T> List<T> said(int messageId, Function<Frame, T> decoder) {
        return frames(true, messageId).stream().map(decoder).toList();
    }

    /** What the vehicle was told of that kind. */
    public <T> List<T> told(int messageId, Function<Frame, T> decoder) {
        return frames(false, messageId).stream().map(decoder).toList();
    }

    private List<Frame> frames(boolean up, int messageId) {
        return heard.stream()
                .filter(one -> one.up() == up && one.frame().messageId() == messageId)
                .map(Heard::frame)
                .toList();
    }
}
