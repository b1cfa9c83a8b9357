package org.dronemap.ws.wire;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.dronemap.proxy.roslink.wire.PacketLayout;
import org.dronemap.proxy.roslink.wire.PacketReadResult;
import org.dronemap.proxy.roslink.wire.RobotMessage;
import org.dronemap.proxy.roslink.wire.RobotOrder;
import org.dronemap.proxy.roslink.wire.RobotOrderWriter;
import org.dronemap.proxy.roslink.wire.RoslinkHeader;
import org.dronemap.proxy.roslink.wire.RoslinkPacketReader;
import org.dronemap.proxy.roslink.wire.StringOrNumber;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** What robots are told and what is understood of them, found out by asking the classes that write and read it. */
final class RobotProtocolDescription {
    private static final JsonMapper JSON = new JsonMapper();
    private static final String WIRE = "org.dronemap.proxy.roslink.wire.";
    private static final int IDS = 256;
    private static final Map<String, JsonNode> VALUES = Map.of(
            "number", JSON.readTree("2"),
            "text", JSON.readTree("\"AAAA\""),
            "list of numbers", JSON.readTree("[2]"),
            "object", JSON.readTree("{\"message_id\":9}"));

    private RobotProtocolDescription() {}

    /** Each order there is, in each layout. */
    static String said() {
        ArrayNode all = JSON.createArrayNode();
        for (Class<?> kind : RobotOrder.class.getPermittedSubclasses()) {
            for (PacketLayout shape : PacketLayout.values()) {
                RoslinkHeader robot = new RoslinkHeader(
                        shape, 5, 0, 1L, new StringOrNumber("key", false), new StringOrNumber("26", true), 1, 2);
                byte[] written = new RobotOrderWriter().write(robot, (RobotOrder) new RecordSample(true).of(kind));
                all.add(JSON.readTree(written));
            }
        }
        return PrettyJson.of(all);
    }

    /**
     * Each number of a message that is known, with the members that make a difference there. Each word in the code of the readers
     * is tried as a member, with values of several types: none can be forgotten here.
     */
    static String heard() throws IOException {
        Set<String> words = new TreeSet<>(ClassStringConstants.of(WIRE + "RobotMessageReader"));
        words.addAll(ClassStringConstants.of(WIRE + "RoslinkPacketReader"));
        // Where the members of a header stand is seen by trying them there.
        words.remove("header");
        Set<Class<?>> kinds = new HashSet<>();
        StringBuilder text = new StringBuilder("header\n").append(members(0, words, true));
        for (int id = 0; id < IDS; id++) {
            Set<Class<?>> found = kindsOf(id, words);
            kinds.addAll(found);
            if (!found.equals(Set.of(RobotMessage.Unknown.class))) {
                text.append("message ").append(id).append('\n').append(members(id, words, false));
            }
        }
        if (!kinds.equals(Set.of(RobotMessage.class.getPermittedSubclasses()))) {
            throw new IllegalStateException("some kind of message is never understood: only " + kinds);
        }
        return text.toString();
    }

    private static Set<Class<?>> kindsOf(int id, Set<String> words) {
        Set<Class<?>> kinds = new HashSet<>();
        for (String word : words) {
            for (JsonNode value : VALUES.values()) {
                if (read(id, word, value, false) instanceof PacketReadResult.Good good) {
                    kinds.add(good.packet().message().getClass());
                }
            }
        }
        return kinds;
    }

    private static String members(int id, Set<String> words, boolean inHeader) {
        StringBuilder text = new StringBuilder();
        PacketReadResult without = read(id, "nothing", JSON.readTree("1"), inHeader);
        for (String word : words) {
            List<String> types = VALUES.entrySet().stream()
                    .filter(value -> makesADifference(read(id, word, value.getValue(), inHeader), without))
                    .map(Map.Entry::getKey)
                    .sorted()
                    .toList();
            if (!types.isEmpty()) {
                text.append("  ")
                        .append(word)
                        .append(": ")
                        .append(String.join(", ", types))
                        .append('\n');
            }
        }
        return text.toString();
    }

    private static boolean makesADifference(PacketReadResult with, PacketReadResult without) {
        return with instanceof PacketReadResult.Good && !with.equals(without);
    }

    private static PacketReadResult read(int id, String word, JsonNode value, boolean inHeader) {
        ObjectNode message = JSON.createObjectNode();
        ObjectNode header = message.putObject("header").put("system_id", 5).put("message_id", id);
        // Images without it are nothing at all, whatever else they say.
        message.put("data", "BBBB");
        (inHeader ? header : message).set(word, value);
        return new RoslinkPacketReader().read(ByteBuffer.wrap(message.toString().getBytes(StandardCharsets.UTF_8)));
    }
}
