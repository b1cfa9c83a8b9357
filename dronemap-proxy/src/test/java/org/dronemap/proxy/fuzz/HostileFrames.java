package org.dronemap.proxy.fuzz;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameSigner;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.MessageTable;
import org.dronemap.mavlink.PayloadWriter;

/** Makes frames with a right checksum and a payload that nobody would send: every known message, odd lengths and values. */
final class HostileFrames {
    /** What the product looks into; the others it only passes. */
    private static final int[] FAVOURITES = {
        0, 1, 4, 20, 22, 23, 24, 30, 33, 39, 40, 42, 43, 44, 45, 46, 47, 51, 73, 74, 75, 76, 77, 80, 87, 109, 111, 117,
        118, 119, 120, 121, 141, 147, 148, 230, 242, 245, 253, 256
    };

    private static final int[] EDGES = {
        0, 1, -1, 0x7FC0_0000, 0x7F80_0000, 0xFF80_0000, 0x7FFF_FFFF, 0x8000_0000, 0xFFFF, 0x7FFF, 0x8000, 0xFF
    };

    private static final int[] KNOWN = IntStream.range(0, 65_536)
            .filter(id -> MessageTable.find(id) != null)
            .toArray();

    private final Random random;
    private final List<FrameWriter> writers = new ArrayList<>();

    /** A payload as it stands. */
    private record Raw(int messageId, byte[] payload) implements Message {
        @Override
        public void write(PayloadWriter out) {
            for (byte octet : payload) {
                out.u8(octet);
            }
        }
    }

    HostileFrames(Random random, int systems) {
        this.random = random;
        for (int system = 1; system <= systems; system++) {
            writers.add(new FrameWriter(system, 1, 2));
            writers.add(new FrameWriter(system, 1, 1));
            writers.add(new FrameWriter(system, 191, 2));
        }
    }

    byte[] next() {
        int[] from = random.nextInt(4) == 0 ? KNOWN : FAVOURITES;
        return frame(from[random.nextInt(from.length)]);
    }

    byte[] frame(int messageId) {
        FrameWriter writer = writers.get(random.nextInt(writers.size()));
        int longest = longest(messageId);
        int length = random.nextInt(3) == 0 ? random.nextInt(256) : longest;
        if (messageId > 255) {
            writer = writers.get(0);
        }
        return writer.frame(new Raw(messageId, payload(Math.max(1, length))));
    }

    /** One of the first system's autopilot, rightly framed, that this signer signs. */
    byte[] signed(FrameSigner signer) {
        int messageId = FAVOURITES[random.nextInt(FAVOURITES.length)];
        int length = random.nextInt(3) == 0 ? random.nextInt(256) : longest(messageId);
        return writers.get(0).frame(new Raw(messageId, payload(Math.max(1, length))), signer);
    }

    private static int longest(int messageId) {
        MessageTable.Entry entry = MessageTable.find(messageId);
        if (entry == null) {
            throw new IllegalArgumentException("message " + messageId + " is not known");
        }
        return entry.longestPayload();
    }

    private byte[] payload(int length) {
        byte[] payload = new byte[length];
        random.nextBytes(payload);
        int kind = random.nextInt(4);
        ByteBuffer words = ByteBuffer.wrap(payload).order(java.nio.ByteOrder.LITTLE_ENDIAN);
        for (int at = 0; at + 4 <= length && kind > 0; at += 4) {
            boolean edge = kind == 1 || random.nextBoolean();
            if (edge) {
                words.putInt(at, kind == 3 ? random.nextInt(512) : EDGES[random.nextInt(EDGES.length)]);
            }
        }
        // Often meant for us: otherwise most answers would be passed over.
        for (int at = 0; at < Math.min(length, 6) && kind == 2; at++) {
            payload[at] = (byte) (random.nextBoolean() ? 255 : random.nextInt(12));
        }
        return payload;
    }

    static List<Frame> parsed(byte[] bytes) {
        List<Frame> frames = new ArrayList<>();
        new FrameReader().read(ByteBuffer.wrap(bytes), frames::add);
        return frames;
    }
}
