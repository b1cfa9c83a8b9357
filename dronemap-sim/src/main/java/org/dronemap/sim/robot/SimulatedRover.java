package org.dronemap.sim.robot;

import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.JsonNode;

/**
 * A simulated two-wheeled ROSLink robot in a {@link SimulatedRoom}, with range finder, camera and map. Metres, radians.
 */
final class SimulatedRover implements SimulatedRobotMachine {
    private static final int TURTLEBOT = 8;
    private static final double RADIUS = 0.15;
    private static final double FASTEST = 0.5;
    private static final double FASTEST_TURN = 1.5;
    private static final double TWIST_SECONDS = 0.5;
    private static final int RAYS = 180;
    private static final double FARTHEST = 3.5;
    private static final double ARRIVED = 0.05;

    private final Set<BridgeQuirk> quirks;
    private double x;
    private double y;
    private double yaw;
    private double speed;
    private double turn;
    private double sinceTwist;
    private double @Nullable [] goal;

    SimulatedRover(double x, double y, Set<BridgeQuirk> quirks) {
        this.x = x;
        this.y = y;
        this.quirks = quirks;
    }

    @Override
    public int type() {
        return TURTLEBOT;
    }

    @Override
    public void move(double seconds) {
        sinceTwist += seconds;
        if (goal != null) {
            steer(goal);
        } else if (sinceTwist > TWIST_SECONDS && !quirks.contains(BridgeQuirk.REPEATS_TWIST)) {
            stop();
        }
        yaw = Math.IEEEremainder(yaw + turn * seconds, 2 * Math.PI);
        double nextX = x + speed * Math.cos(yaw) * seconds;
        double nextY = y + speed * Math.sin(yaw) * seconds;
        if (touches(nextX, nextY)) {
            speed = 0;
        } else {
            x = nextX;
            y = nextY;
        }
    }

    private static boolean touches(double x, double y) {
        return SimulatedRoom.isSolid(x + RADIUS, y)
                || SimulatedRoom.isSolid(x - RADIUS, y)
                || SimulatedRoom.isSolid(x, y + RADIUS)
                || SimulatedRoom.isSolid(x, y - RADIUS);
    }

    private void steer(double[] to) {
        double far = Math.hypot(to[0] - x, to[1] - y);
        if (far < ARRIVED) {
            goal = null;
            stop();
            return;
        }
        double off = Math.IEEEremainder(Math.atan2(to[1] - y, to[0] - x) - yaw, 2 * Math.PI);
        turn = bounded(3 * off, FASTEST_TURN);
        speed = Math.abs(off) > 0.3 ? 0 : bounded(2 * far, FASTEST);
    }

    private void stop() {
        speed = 0;
        turn = 0;
    }

    private static double bounded(double value, double most) {
        return Math.max(-most, Math.min(most, value));
    }

    @Override
    public SimulatedRobotFleet.GroundTruth truth() {
        return new SimulatedRobotFleet.GroundTruth(x, y, 0, Math.max(Math.abs(speed), Math.abs(turn)), false);
    }

    @Override
    public Map<String, Object> status() {
        return Map.of();
    }

    /** Its z is a yaw, as bridges of ground robots have it. */
    @Override
    public Map<String, Object> motion() {
        return Map.of("x", x, "y", y, "z", yaw, "vx", speed, "vy", 0.0, "vz", 0.0, "wx", 0.0, "wy", 0.0, "wz", turn);
    }

    @Override
    public Map<Integer, Map<String, Object>> images() {
        return Map.of(4, scan(), 5, Map.of("data", base64(SimulatedRoom.view(x, y, yaw)), "height", 240, "width", 320));
    }

    private Map<String, Object> scan() {
        double step = 2 * Math.PI / RAYS;
        List<Double> ranges = new ArrayList<>();
        for (int ray = 0; ray < RAYS; ray++) {
            ranges.add(SimulatedRoom.range(x, y, yaw - Math.PI + ray * step, FARTHEST));
        }
        return Map.of(
                "angle_min",
                -Math.PI,
                "angle_max",
                Math.PI - step,
                "angle_increment",
                step,
                "range_min",
                0.1,
                "range_max",
                FARTHEST,
                "ranges",
                ranges);
    }

    @Override
    public Map<String, Object> map() {
        return Map.of(
                "data",
                base64(SimulatedRoom.map()),
                "width",
                SimulatedRoom.WIDTH,
                "height",
                SimulatedRoom.HEIGHT,
                "xoffset",
                -SimulatedRoom.WIDTH / 2,
                "yoffset",
                -SimulatedRoom.HEIGHT / 2);
    }

    private String base64(byte[] bytes) {
        return quirks.contains(BridgeQuirk.BROKEN_LINES)
                ? Base64.getMimeEncoder().encodeToString(bytes)
                : Base64.getEncoder().encodeToString(bytes);
    }

    @Override
    public void cloudLost() {
        goal = null;
        stop();
    }

    @Override
    public void execute(int order, JsonNode body) {
        if (order == RobotOrderIds.TWIST) {
            // As navigation stacks do it: speeds from elsewhere do not end a journey, only its cancelling does.
            if (goal == null) {
                speed = bounded(body.path("vx").asDouble(0), FASTEST);
                turn = bounded(body.path("wz").asDouble(0), FASTEST_TURN);
                sinceTwist = 0;
            }
        } else if (order == RobotOrderIds.GO_TO) {
            goal = new double[] {body.path("x").asDouble(x), body.path("y").asDouble(y)};
        } else if (order == RobotOrderIds.STOP) {
            goal = null;
            stop();
        }
    }
}
