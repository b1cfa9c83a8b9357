package org.dronemap.proxy.roslink.wire;

import org.dronemap.proxy.roslink.wire.RobotMessage.Angles;
import org.dronemap.proxy.roslink.wire.RobotMessage.Triple;
import org.dronemap.proxy.roslink.wire.RobotMessage.View;
import org.jspecify.annotations.Nullable;

/** Parses the bodies of ROSLink messages from robots by message id. */
final class RobotMessageReader {
    private static final int HEARTBEAT = 0;
    private static final int STATUS = 1;
    private static final int MOTION = 2;
    private static final int SATELLITES = 3;
    private static final int SCAN = 4;
    private static final int IMAGE = 5;
    private static final int MAP = 6;
    private static final int PLACED_IMAGE = 7;

    /** More than any range finder in use measures in one sweep. */
    private static final int MOST_RANGES = 8_192;

    private RobotMessageReader() {}

    /** Null when that kind of message makes no sense with such a body. */
    static @Nullable RobotMessage read(int messageId, JsonFields body) {
        return switch (messageId) {
            case HEARTBEAT -> heartbeat(body);
            case STATUS -> isHeartbeat(body) ? heartbeat(body) : status(body);
            case MOTION -> motion(body);
            case SATELLITES -> satellites(body);
            case SCAN -> scan(body);
            case IMAGE -> image(body, null);
            case MAP -> map(body);
            case PLACED_IMAGE -> image(body, new View(body.number("lat"), body.number("lon"), body.number("alt")));
            default -> new RobotMessage.Unknown();
        };
    }

    /** Some bridges send the body of a heartbeat where a status is due. */
    private static boolean isHeartbeat(JsonFields body) {
        boolean status = body.has("state")
                || body.has("voltage_battery")
                || body.has("current_battery")
                || body.has("battery_remaining");
        return !status && (body.has("type") || body.has("system_status"));
    }

    private static RobotMessage heartbeat(JsonFields body) {
        return new RobotMessage.Heartbeat(
                body.code("type"), body.text("name"), body.code("system_status"), body.code("mode"));
    }

    private static RobotMessage status(JsonFields body) {
        return new RobotMessage.Status(
                body.code("state"),
                body.number("voltage_battery"),
                body.number("current_battery"),
                body.number("battery_remaining"));
    }

    private static RobotMessage motion(JsonFields body) {
        return new RobotMessage.Motion(
                triple(body, "x", "y", "z"),
                triple(body, "vx", "vy", "vz"),
                triple(body, "wx", "wy", "wz"),
                new Angles(
                        body.number("pitch"),
                        body.number("roll"),
                        body.has("heading") ? body.number("heading") : body.number("yaw")));
    }

    private static Triple triple(JsonFields body, String x, String y, String z) {
        return new Triple(body.number(x), body.number(y), body.number(z));
    }

    private static RobotMessage satellites(JsonFields body) {
        return new RobotMessage.Satellites(
                body.code("fix_type"),
                body.number("lat"),
                body.number("lon"),
                body.number("alt"),
                body.count("satellites_visible", 254));
    }

    private static RobotMessage scan(JsonFields body) {
        return new RobotMessage.Scan(
                body.number("angle_min"),
                body.number("angle_increment"),
                body.number("range_min"),
                body.number("range_max"),
                body.numbers("ranges", MOST_RANGES));
    }

    private static @Nullable RobotMessage image(JsonFields body, @Nullable View view) {
        String data = body.data("data");
        return data == null ? null : new RobotMessage.Image(data, view);
    }

    private static @Nullable RobotMessage map(JsonFields body) {
        String data = body.data("data");
        return data == null
                ? null
                : new RobotMessage.MapImage(
                        data,
                        body.number("width"),
                        body.number("height"),
                        body.number("xoffset"),
                        body.number("yoffset"),
                        body.number("resolution"));
    }
}
