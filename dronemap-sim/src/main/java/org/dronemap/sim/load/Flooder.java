package org.dronemap.sim.load;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.locks.LockSupport;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;

/** Load test: floods a server with seeded garbage from one address. One thread. One thread. */
final class Flooder {
    private static final int KINDS_OF_DATAGRAMS = 4_096;
    private static final int LONGEST_NOISE = 300;
    private static final long MILLI = 1_000_000L;
    private static final int SYSTEM_IDS = 254;
    /** Messages that make a server work: telemetry, parameters, missions, texts. */
    private static final int[] MESSAGES = {0, 1, 22, 24, 30, 33, 39, 42, 44, 47, 51, 73, 74, 77, 111, 147, 148, 242, 253
    };

    private static final int[] LENGTHS = {9, 31, 25, 30, 28, 28, 37, 2, 4, 3, 4, 37, 20, 3, 16, 36, 60, 52, 51};

    private final int perSecond;
    private final long fromNanos;
    private final long untilNanos;
    private final InetSocketAddress server;
    private final List<byte[]> datagrams = new ArrayList<>(KINDS_OF_DATAGRAMS);

    /** A message with any payload, from a seed. */
    private record Noise(int messageId, int length, long seed) implements Message {
        @Override
        public void write(PayloadWriter out) {
            Random chance = new Random(seed);
            for (int i = 0; i < length; i++) {
                out.u8(chance.nextInt(256));
            }
        }
    }

    Flooder(LoadArguments arguments) {
        perSecond = arguments.integer("--rate");
        fromNanos = arguments.longInteger("--from-nanos");
        untilNanos = arguments.longInteger("--until-nanos");
        server = new InetSocketAddress(InetAddress.getLoopbackAddress(), arguments.integer("--port"));
        boolean hostile = arguments.text("--kind").equals("hostile");
        Random chance = new Random(arguments.longInteger("--seed"));
        for (int i = 0; i < KINDS_OF_DATAGRAMS; i++) {
            datagrams.add(hostile ? hostile(chance) : broken(chance));
        }
    }

    String run() throws IOException {
        long sent = 0;
        long refused = 0;
        try (DatagramChannel channel = DatagramChannel.open()) {
            channel.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
            channel.connect(server);
            channel.configureBlocking(false);
            SendSchedule.await(fromNanos);
            for (long now = System.nanoTime(); now < untilNanos; now = System.nanoTime()) {
                long due = (now - fromNanos) * perSecond / 1_000_000_000L;
                for (long number = sent + refused; number < due; number++) {
                    byte[] datagram = datagrams.get((int) (number % KINDS_OF_DATAGRAMS));
                    if (channel.write(ByteBuffer.wrap(datagram)) == datagram.length) {
                        sent++;
                    } else {
                        refused++;
                    }
                }
                LockSupport.parkNanos(MILLI);
            }
        }
        return "{\"sent\":" + sent + ",\"refused\":" + refused + "}";
    }

    /** Noise, frames with a wrong checksum, lengths that lie. */
    private static byte[] broken(Random chance) {
        byte[] bytes;
        if (chance.nextInt(3) == 0) {
            bytes = new byte[1 + chance.nextInt(LONGEST_NOISE)];
            chance.nextBytes(bytes);
            bytes[0] = (byte) 0xFD;
            return bytes;
        }
        bytes = hostile(chance);
        if (chance.nextBoolean()) {
            bytes[bytes.length - 1]++;
        } else {
            bytes[1] = (byte) chance.nextInt();
        }
        return bytes;
    }

    /** Frames that pass every check and mean nothing good, now and then in another vehicle's name. */
    private static byte[] hostile(Random chance) {
        int kind = chance.nextInt(MESSAGES.length);
        int systemId = 1 + (chance.nextBoolean() ? 0 : chance.nextInt(SYSTEM_IDS));
        return new FrameWriter(systemId, 1, 2).frame(new Noise(MESSAGES[kind], LENGTHS[kind], chance.nextLong()));
    }
}
