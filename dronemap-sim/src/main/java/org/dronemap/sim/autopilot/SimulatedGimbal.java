package org.dronemap.sim.autopilot;

import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.GimbalDeviceAttitudeStatus;
import org.dronemap.mavlink.message.GimbalManagerSetPitchyaw;

/** The camera gimbal of a simulated vehicle: looks up and down, level with the horizon. Owned by its vehicle. */
public final class SimulatedGimbal {
    private static final int RETRACT = 1;
    private static final int NEUTRAL = 2;
    private static final int LEVEL = 4 | 8;
    private static final double DEGREES_PER_SECOND = 60;
    private static final double LOWEST = -90;
    private static final double HIGHEST = 30;

    private double wanted;
    private double pitch;

    /** Degrees above the horizon. */
    public double pitchDegrees() {
        return pitch;
    }

    /** As ArduPilot does: neutral goes before angles, and an angle that is no number is none. */
    void apply(GimbalManagerSetPitchyaw message) {
        if ((message.flags() & (RETRACT | NEUTRAL)) != 0) {
            wanted = 0;
        } else if (Float.isFinite(message.pitch()) && Float.isFinite(message.yaw())) {
            wanted = Math.max(LOWEST, Math.min(HIGHEST, Math.toDegrees(message.pitch())));
        }
    }

    void step(double seconds) {
        double most = DEGREES_PER_SECOND * seconds;
        pitch += Math.max(-most, Math.min(most, wanted - pitch));
    }

    Message status(long bootMillis) {
        double half = Math.toRadians(pitch) / 2;
        return new GimbalDeviceAttitudeStatus(
                0,
                0,
                bootMillis,
                LEVEL,
                new float[] {(float) Math.cos(half), 0, (float) Math.sin(half), 0},
                0,
                0,
                0,
                0,
                0,
                0);
    }
}
