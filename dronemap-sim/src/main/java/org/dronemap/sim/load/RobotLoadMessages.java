package org.dronemap.sim.load;

import java.util.Locale;

/** Load test: the ROSLink messages of one sending robot, derived from its number and rate. Not thread-safe. */
final class RobotLoadMessages {
    private static final int HEARTBEAT = 0;
    private static final int MOTION = 2;
    private static final int SCAN = 4;
    private static final int FIRST_SYSTEM_ID = 1_000;
    /** As of a usual range finder, a degree each. */
    private static final String RANGES = "1.234,2.345,3.456".concat(",1.234,2.345,3.456".repeat(119));

    private final int robot;
    private final int perSecond;
    private int sequence;
    private int step;

    RobotLoadMessages(int robot, int perSecond) {
        this.robot = robot;
        this.perSecond = perSecond;
    }

    /** The next step: once a second a heartbeat, once a sweep of its range finder, and else how it moves. */
    String next() {
        int kind = step % perSecond;
        String text = switch (kind) {
            case 0 -> heartbeat();
            case 1 -> scan();
            default -> motion();
        };
        step++;
        return text;
    }

    boolean nextIsHeartbeat() {
        return step % perSecond == 0;
    }

    String heartbeat() {
        return message(HEARTBEAT, "\"type\":8,\"name\":\"load\",\"system_status\":2,\"mode\":0");
    }

    private String scan() {
        return message(
                SCAN,
                "\"angle_min\":0,\"angle_increment\":0.01745,\"range_min\":0.1,\"range_max\":3.5,\"ranges\":[" + RANGES
                        + "]");
    }

    /** Also the farewell: it stands where it came to. */
    String motion() {
        return message(
                MOTION,
                String.format(
                        Locale.ROOT, "\"x\":%d,\"y\":%d,\"z\":0,\"vx\":0,\"vy\":0,\"vz\":0,\"wz\":0", step, robot));
    }

    private String message(int kind, String body) {
        sequence++;
        return "{\"header\":{\"roslink_version\":1,\"ros_version\":8,\"system_id\":" + (FIRST_SYSTEM_ID + robot)
                + ",\"message_id\":" + kind + ",\"sequence_number\":" + sequence + ",\"key\":\"load-" + robot + "\"},"
                + body + "}";
    }
}
