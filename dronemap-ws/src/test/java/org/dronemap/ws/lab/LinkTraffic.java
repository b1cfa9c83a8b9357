package org.dronemap.ws.lab;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;

/** What was said on a wire in both directions, whether or not it came to its other end. */
public final class LinkTraffic {
    private final List<Datagram> all = new ArrayList<>();

    private record Datagram(boolean up, long atNanos, byte[] bytes) {}

    /** One frame, and when it was sent, in ns of the laboratory's time. */
    public record Heard(long atNanos, Frame frame) {}

    void add(boolean up, long atNanos, byte[] bytes) {
        all.add(new Datagram(up, atNanos, bytes));
    }

    /** What the vehicle said, of these messages, from that time on. */
    public List<Heard> up(long sinceNanos, int... messages) {
        return heard(true, sinceNanos, messages);
    }

    /** What it was told. */
    public List<Heard> down(long sinceNanos, int... messages) {
        return heard(false, sinceNanos, messages);
    }

    private List<Heard> heard(boolean up, long sinceNanos, int... messages) {
        FrameReader reader = new FrameReader();
        List<Heard> found = new ArrayList<>();
        for (Datagram one : all) {
            if (one.up() == up && one.atNanos() >= sinceNanos) {
                reader.read(ByteBuffer.wrap(one.bytes()), frame -> {
                    if (Arrays.stream(messages).anyMatch(id -> id == frame.messageId())) {
                        found.add(new Heard(one.atNanos(), frame));
                    }
                });
            }
        }
        return found;
    }
}
