package org.dronemap.proxy.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Random;
import org.dronemap.proxy.roslink.wire.Base64Text;
import org.dronemap.proxy.roslink.wire.PacketReadResult;
import org.dronemap.proxy.roslink.wire.RobotMessage;
import org.dronemap.proxy.roslink.wire.RobotOrder;
import org.dronemap.proxy.roslink.wire.RobotOrderWriter;
import org.dronemap.proxy.roslink.wire.RobotSequenceTracker;
import org.dronemap.proxy.roslink.wire.RoslinkPacket;
import org.dronemap.proxy.roslink.wire.RoslinkPacketReader;

/** Messages of robots, cut, spliced and with anything for a value: each is a message or says why it is none. */
final class PacketFuzz {
    private static final String[] NAMES = {
        "header",
        "payload",
        "system_id",
        "message_id",
        "sequence_number",
        "key",
        "owner_id",
        "type",
        "name",
        "state",
        "x",
        "y",
        "z",
        "vx",
        "heading",
        "yaw",
        "lat",
        "lon",
        "alt",
        "fix_type",
        "ranges",
        "data",
        "width",
        "resolution"
    };
    private static final String[] VALUES = {
        "0",
        "1",
        "-1",
        "7",
        "1.0",
        "1e308",
        "1e999",
        "-0.0",
        "NaN",
        "Infinity",
        "-Infinity",
        "null",
        "true",
        "\"\"",
        "\"1\"",
        "\"0x10\"",
        "\"1e5\"",
        "\"\\ud800\"",
        "\"\\u0000\"",
        "[]",
        "{}",
        "[1,NaN,\"a\"]",
        "9007199254740993",
        "123456789012345678901234567890",
        "\"AAAA\\nAAAA\\n\"",
        "\"====\""
    };
    private static final int WARM_UP = 2_000;

    private final Random random;
    private final RoslinkPacketReader reader = new RoslinkPacketReader();
    private final RobotOrderWriter writer = new RobotOrderWriter();
    private RobotSequenceTracker watch = new RobotSequenceTracker();

    private PacketFuzz(Random random) {
        this.random = random;
    }

    static long run(FuzzBudget budget) {
        PacketFuzz fuzz = new PacketFuzz(budget.random());
        HeapGrowthCheck heap = new HeapGrowthCheck();
        long rounds = 0;
        long good = 0;
        while (budget.isLeft()) {
            byte[] input = fuzz.input();
            boolean[] wasGood = new boolean[1];
            if (rounds++ < WARM_UP) {
                wasGood[0] = fuzz.feed(input);
            } else {
                SlowInputCheck.check(budget.name(), input, () -> wasGood[0] = fuzz.feed(input));
            }
            good += wasGood[0] ? 1 : 0;
        }
        heap.check(budget.name());
        assertThat(good).as("messages among them, " + budget.name()).isPositive();
        return rounds;
    }

    /** True for a message. */
    private boolean feed(byte[] input) {
        ByteBuffer buffer = ByteBuffer.wrap(input);
        PacketReadResult reading = reader.read(buffer);
        assertThat(buffer.hasRemaining()).isFalse();
        if (!(reading instanceof PacketReadResult.Good good)) {
            return false;
        }
        RoslinkPacket packet = good.packet();
        watch.isNew(packet.header());
        if (random.nextInt(1_000) == 0) {
            watch = new RobotSequenceTracker();
        }
        if (packet.message() instanceof RobotMessage.Image image) {
            Base64Text.decode(image.base64());
        }
        byte[] answer = writer.write(packet.header(), RobotOrder.Twist.STOP);
        assertThat(reader.read(ByteBuffer.wrap(answer))).isInstanceOf(PacketReadResult.Good.class);
        return true;
    }

    private byte[] input() {
        String text = random.nextInt(3) == 0 ? object(0) : robot();
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        switch (random.nextInt(6)) {
            case 0 -> bytes[random.nextInt(bytes.length)] = (byte) random.nextInt(256);
            case 1 -> bytes = Arrays.copyOf(bytes, random.nextInt(bytes.length + 1));
            case 2 -> random.nextBytes(bytes);
            default -> {}
        }
        return bytes;
    }

    private String robot() {
        String ids = "\"system_id\":" + random.nextInt(300) + ",\"message_id\":" + random.nextInt(9);
        String more = "\"sequence_number\":" + (random.nextBoolean() ? random.nextInt(50) : random.nextLong());
        return random.nextBoolean()
                ? "{\"header\":{" + ids + "," + more + "}," + fields(1) + "}"
                : "{" + ids + "," + more + ",\"payload\":" + object(1) + "}";
    }

    private String object(int depth) {
        return "{" + fields(depth) + "}";
    }

    private String fields(int depth) {
        StringBuilder fields = new StringBuilder();
        for (int count = 1 + random.nextInt(6); count > 0; count--) {
            fields.append(fields.isEmpty() ? "" : ",")
                    .append('"')
                    .append(NAMES[random.nextInt(NAMES.length)])
                    .append("\":")
                    .append(depth < 12 && random.nextInt(5) == 0 ? object(depth + 1) : value());
        }
        return fields.toString();
    }

    private String value() {
        return VALUES[random.nextInt(VALUES.length)];
    }
}
