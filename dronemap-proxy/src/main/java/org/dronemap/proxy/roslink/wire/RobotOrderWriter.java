package org.dronemap.proxy.roslink.wire;

import java.nio.charset.StandardCharsets;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/**
 * Writes the server's ROSLink orders to one robot as JSON, in the layout of that robot's newest message. Owned by the
 * session's lane.
 */
public final class RobotOrderWriter {
    private static final JsonMapper MAPPER = JsonMapper.shared();
    /** A ground station, in the list of what speaks this protocol. */
    private static final int GROUND_STATION = 7;

    private static final int ACTIVE = 2;
    private static final int NO_MODE = 0;

    private int sequence;

    /** {@code robot}: a header that the robot has sent itself. */
    public byte[] write(RoslinkHeader robot, RobotOrder order) {
        sequence = sequence == Integer.MAX_VALUE ? 1 : sequence + 1;
        ObjectNode message = MAPPER.createObjectNode();
        boolean nested = robot.shape() == PacketLayout.NESTED_HEADER;
        writeHeader(nested ? message.putObject("header") : message, robot, order);
        ObjectNode body = nested ? message : message.putObject("payload");
        if (order instanceof RobotOrder.Heartbeat) {
            writeHeartbeat(body, robot);
        } else {
            writeBody(body, order);
        }
        return message.toString().getBytes(StandardCharsets.UTF_8);
    }

    private void writeHeader(ObjectNode header, RoslinkHeader robot, RobotOrder order) {
        header.put("roslink_version", robot.version())
                .put("ros_version", robot.rosVersion())
                .put("system_id", robot.systemId())
                .put("message_id", order.messageId())
                .put("sequence_number", sequence);
        put(header, "key", robot.key());
        put(header, "owner_id", robot.owner());
    }

    private static void put(ObjectNode header, String name, @Nullable StringOrNumber word) {
        if (word != null && word.number()) {
            header.put(name, Long.parseLong(word.text()));
        } else if (word != null) {
            header.put(name, word.text());
        }
    }

    /** With the robot's owner, as the protocol has it there: the cloud itself belongs to nobody. */
    private static void writeHeartbeat(ObjectNode body, RoslinkHeader robot) {
        body.put("type", GROUND_STATION).put("name", "dronemap").put("system_status", ACTIVE);
        put(body, "owner_id", robot.owner());
        body.put("mode", NO_MODE);
    }

    private static void writeBody(ObjectNode body, RobotOrder order) {
        if (order instanceof RobotOrder.Twist twist) {
            body.put("vx", twist.vx()).put("vy", twist.vy()).put("vz", twist.vz());
            body.put("wx", twist.wx()).put("wy", twist.wy()).put("wz", twist.wz());
        } else if (order instanceof RobotOrder.GoTo goTo) {
            body.put("x", goTo.x()).put("y", goTo.y()).put("z", goTo.z());
            // A word, not a truth value: that is what bridges compare with.
            body.put("frame_type", goTo.robotFrame() ? "true" : "false");
        } else if (order instanceof RobotOrder.TakeOff takeOff) {
            body.put("altitude", takeOff.altitude());
        } else if (order instanceof RobotOrder.SetMode setMode) {
            body.put("flightMode", setMode.mode());
        }
    }
}
