package org.dronemap.sim.autopilot;

import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.CommandLong;

/** A COMMAND_LONG or COMMAND_INT that a simulated vehicle received, in one form with degrees and metres. */
public record MavCommand(
        int command,
        boolean withFrame,
        int frame,
        float param1,
        float param2,
        float param3,
        float param4,
        double latitude,
        double longitude,
        float altitude) {

    private static final int FRAME_RELATIVE = 3;

    public static MavCommand of(CommandLong message) {
        return new MavCommand(
                message.command(),
                false,
                FRAME_RELATIVE,
                message.param1(),
                message.param2(),
                message.param3(),
                message.param4(),
                message.param5(),
                message.param6(),
                message.param7());
    }

    public static MavCommand of(CommandInt message) {
        return new MavCommand(
                message.command(),
                true,
                message.frame(),
                message.param1(),
                message.param2(),
                message.param3(),
                message.param4(),
                message.x() / 1e7,
                message.y() / 1e7,
                message.z());
    }

    public boolean isAmsl() {
        return frame == 0 || frame == 5;
    }

    /** Of DO_DIGICAM_CONTROL: its fifth parameter says whether to take a picture. */
    public boolean shoots() {
        return Math.round(withFrame ? latitude * 1e7 : latitude) == 1;
    }

    public boolean isOnEarth() {
        return Math.abs(latitude) <= 90 && Math.abs(longitude) <= 180;
    }
}
