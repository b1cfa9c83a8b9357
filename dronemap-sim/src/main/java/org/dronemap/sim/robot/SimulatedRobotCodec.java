package org.dronemap.sim.robot;

import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.dronemap.sim.robot.RobotOptions.Identity;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/**
 * Writes the ROSLink messages of one simulated robot, and reads orders to it, with the quirks of its bridge. Owned by
 * the fleet's thread.
 */
final class SimulatedRobotCodec {
    private static final int LAST_OF_A_KIND = 15_000;
    private static final int EVERY_KIND = -1;

    private final Identity identity;
    private final Set<BridgeQuirk> quirks;
    private final Map<Integer, Integer> sequence = new HashMap<>();

    SimulatedRobotCodec(Identity identity, Set<BridgeQuirk> quirks) {
        this.identity = identity;
        this.quirks = quirks;
    }

    String text(int messageId, Map<String, Object> body) {
        ObjectNode message = JsonMapper.shared().createObjectNode();
        boolean payload = quirks.contains(BridgeQuirk.PAYLOAD_SHAPE);
        ObjectNode header = payload ? message : message.putObject("header");
        header.put("roslink_version", 1)
                .put("ros_version", 8)
                .put("system_id", identity.systemId())
                .put("message_id", messageId)
                .put("sequence_number", next(messageId));
        key(header);
        owner(header);
        ObjectNode inner = payload ? message.putObject("payload") : message;
        body.forEach((name, value) -> inner.set(name, JsonMapper.shared().valueToTree(value)));
        return message.toString();
    }

    private void key(ObjectNode header) {
        if (quirks.contains(BridgeQuirk.NUMBER_KEY)) {
            header.put("key", Long.parseLong(identity.key()));
        } else {
            header.put("key", identity.key());
        }
    }

    private void owner(ObjectNode header) {
        String owner = identity.owner();
        if (owner != null && (quirks.contains(BridgeQuirk.TEXT_OWNER) || !owner.matches("\\d{1,9}"))) {
            header.put("owner_id", owner);
        } else if (owner != null) {
            header.put("owner_id", Integer.parseInt(owner));
        }
    }

    private int next(int messageId) {
        boolean each = quirks.contains(BridgeQuirk.COUNTS_EACH_KIND);
        int number = sequence.merge(each ? messageId : EVERY_KIND, 1, Integer::sum);
        if (each && number == LAST_OF_A_KIND) {
            sequence.put(messageId, 0);
        }
        return number;
    }

    /** What it is told; -1 for what is not meant for this robot. A bridge takes the type of its key for a part of it. */
    int order(JsonNode message) {
        JsonNode header = quirks.contains(BridgeQuirk.PAYLOAD_SHAPE) ? message : message.path("header");
        boolean mine = header.path("system_id").asInt(-1) == identity.systemId()
                && header.path("key").isNumber() == quirks.contains(BridgeQuirk.NUMBER_KEY)
                && header.path("key").asString("").equals(identity.key());
        return mine ? header.path("message_id").asInt(-1) : -1;
    }

    JsonNode body(JsonNode message) {
        return quirks.contains(BridgeQuirk.PAYLOAD_SHAPE) ? message.path("payload") : message;
    }
}
