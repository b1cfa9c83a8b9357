package org.dronemap.sim.robot;

import java.util.Map;
import tools.jackson.databind.JsonNode;

/**
 * A simulated ROSLink drone, whose flight controller is behind mavros: ArduCopter's modes, no map, no camera. Metres.
 */
final class SimulatedMavrosDrone implements SimulatedRobotMachine {
    private static final int QUADROTOR = 3;
    private static final int GUIDED = 4;
    private static final int RTL = 6;
    private static final int LAND_MODE = 9;
    private static final int STANDBY = 3;
    private static final int ACTIVE = 4;
    private static final double CLIMB = 2;
    private static final double FASTEST = 3;
    private static final double METERS_A_DEGREE = 111_195;

    private final double latitude;
    private final double longitude;
    private int mode;
    private boolean armed;
    private double height;
    private double wanted;
    private double x;
    private double y;
    private double vx;
    private double vy;

    SimulatedMavrosDrone(double latitude, double longitude) {
        this.latitude = latitude;
        this.longitude = longitude;
    }

    @Override
    public int type() {
        return QUADROTOR;
    }

    @Override
    public void move(double seconds) {
        double way = wanted - height;
        height += Math.copySign(Math.min(Math.abs(way), CLIMB * seconds), way);
        if (height > 0) {
            x += vx * seconds;
            y += vy * seconds;
        } else {
            vx = 0;
            vy = 0;
            armed = armed && (wanted > 0 || (mode != RTL && mode != LAND_MODE));
        }
    }

    @Override
    public SimulatedRobotFleet.GroundTruth truth() {
        return new SimulatedRobotFleet.GroundTruth(x, y, height, Math.hypot(vx, vy), armed);
    }

    @Override
    public Map<String, Object> status() {
        int state = 1_000 * (height > 0 ? ACTIVE : STANDBY) + (armed ? 100 : 0) + mode;
        return Map.of("state", state, "voltage_battery", 12.4, "current_battery", 5.0, "battery_remaining", 83);
    }

    @Override
    public Map<String, Object> motion() {
        return Map.of("x", x, "y", y, "z", height, "vx", vx, "vy", vy, "vz", 0.0, "heading", 0.0);
    }

    /** It never says how high above the sea, as its bridge does not. */
    @Override
    public Map<Integer, Map<String, Object>> images() {
        return Map.of(
                3,
                Map.of(
                        "fix_type",
                        3,
                        "lat",
                        latitude + y / METERS_A_DEGREE,
                        "lon",
                        longitude + x / METERS_A_DEGREE / Math.cos(Math.toRadians(latitude)),
                        "satellites_visible",
                        11));
    }

    @Override
    public Map<String, Object> map() {
        return Map.of();
    }

    @Override
    public void cloudLost() {
        if (height > 0) {
            mode(LAND_MODE);
        }
    }

    @Override
    public void execute(int order, JsonNode body) {
        switch (order) {
            case RobotOrderIds.ARM -> armed = true;
            case RobotOrderIds.DISARM -> armed = armed && height > 0;
            case RobotOrderIds.SET_MODE -> mode(body.path("flightMode").asInt(mode));
            case RobotOrderIds.TAKE_OFF -> {
                if (armed && mode == GUIDED) {
                    wanted = body.path("altitude").asDouble(0);
                }
            }
            case RobotOrderIds.LAND -> wanted = 0;
            case RobotOrderIds.TWIST -> {
                vx = bounded(body.path("vx").asDouble(0));
                vy = bounded(body.path("vy").asDouble(0));
            }
            default -> {
                // Drones take no other orders.
            }
        }
    }

    private void mode(int next) {
        mode = next;
        if (next == RTL || next == LAND_MODE) {
            vx = 0;
            vy = 0;
            wanted = 0;
        }
    }

    private static double bounded(double speed) {
        return Math.max(-FASTEST, Math.min(FASTEST, speed));
    }
}
