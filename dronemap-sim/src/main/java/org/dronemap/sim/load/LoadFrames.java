package org.dronemap.sim.load;

import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Attitude;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.VfrHud;

/**
 * Load test: the frames of one sending vehicle, derived from its number and rate, so that a checker can repeat them.
 * Positions carry vehicle and step: step in the latitude, vehicle in the longitude, in steps of 1e-7 degrees. Not
 * thread-safe.
 */
final class LoadFrames {
    static final int LATITUDE_E7 = 470_000_000;
    static final int LONGITUDE_E7 = 80_000_000;
    static final int VEHICLE_E7 = 1_000;
    private static final int SYSTEM_IDS = 254;
    private static final int QUAD = 2;
    private static final int ARDUPILOT = 3;
    private static final int GUIDED = 4;
    private static final int ARMED_GUIDED = 0x80 | 0x01;
    private static final int DISARMED = 0x01;
    private static final int ACTIVE = 4;
    private static final int STANDBY = 3;

    private final int vehicle;
    private final int perSecond;
    private final boolean onlyPositions;
    private final FrameWriter writer;
    private int step;

    /** {@code onlyPositions}: no other telemetry than positions, as in measurements of how old a position is. */
    LoadFrames(int vehicle, int perSecond, boolean onlyPositions) {
        this.vehicle = vehicle;
        this.perSecond = perSecond;
        this.onlyPositions = onlyPositions;
        this.writer = new FrameWriter(systemId(vehicle), 1, 2);
    }

    static int systemId(int vehicle) {
        return vehicle % SYSTEM_IDS + 1;
    }

    /** The frame of the next step: once a second a heartbeat, armed, and telemetry in between. */
    byte[] next() {
        byte[] frame = writer.frame(message(step));
        step++;
        return frame;
    }

    /** The farewell: disarmed, so that the flight ends. */
    byte[] disarmed() {
        return writer.frame(new Heartbeat(QUAD, ARDUPILOT, DISARMED, GUIDED, STANDBY, 3));
    }

    private Message message(int now) {
        if (now % perSecond == 0) {
            return new Heartbeat(QUAD, ARDUPILOT, ARMED_GUIDED, GUIDED, ACTIVE, 3);
        }
        int kind = onlyPositions ? 0 : now % 4;
        return switch (kind) {
            case 0 -> position(now);
            case 2 -> new VfrHud(12f, 11f, 90, 50, 60f, now % 100 / 100f);
            default -> new Attitude(now, 0.01f * (now % 50), -0.01f, 1.5f, 0f, 0f, vehicle);
        };
    }

    private GlobalPositionInt position(int now) {
        return new GlobalPositionInt(
                now, LATITUDE_E7 + now, LONGITUDE_E7 + vehicle * VEHICLE_E7, 500_000, 50_000, 100, 100, 0, 9_000);
    }
}
