package org.dronemap.cognitive.follow;

import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;

/** How an ArduCopter is told where to be. */
final class SetpointMessages {
    private static final int POSITION_AND_VELOCITY = 0x9C0;
    private static final int POSITION_ONLY = 0xDF8;

    private SetpointMessages() {}

    static SetPositionTargetGlobalInt moving(GuidanceSetpoint aim) {
        return target(aim, POSITION_AND_VELOCITY);
    }

    static SetPositionTargetGlobalInt place(GuidanceSetpoint aim) {
        return target(aim, POSITION_ONLY);
    }

    private static SetPositionTargetGlobalInt target(GuidanceSetpoint aim, int mask) {
        return new SetPositionTargetGlobalInt(
                0,
                1,
                1,
                5,
                mask,
                (int) Math.round(aim.point().latitudeDegrees() * 1e7),
                (int) Math.round(aim.point().longitudeDegrees() * 1e7),
                (float) aim.altitudeAmslMeters(),
                (float) aim.northward(),
                (float) aim.eastward(),
                (float) -aim.upward(),
                0,
                0,
                0,
                (float) Math.toRadians(aim.headingDegrees()),
                0);
    }
}
