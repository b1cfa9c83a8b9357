package org.dronemap.proxy.mavlink.translate;

import java.util.Optional;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.mavlink.message.MissionItemInt;

/**
 * Tells what of a client's mission item would be lost or changed, since the cloud keeps what an item means and writes
 * it anew for the vehicle.
 */
final class MissionItemLoss {
    /** As ArduPilot tells a landing that says nothing of a direction. */
    private static final float CLOCKWISE = 1;

    private MissionItemLoss() {}

    /** Words that follow the item's number; empty: nothing is lost. */
    static Optional<String> of(MissionItemInt item, MissionCodec.Form form) {
        if (item.command() == MissionCodec.NAV_TAKEOFF && form.takeOffPitch() != 0) {
            return item.param1() == form.takeOffPitch()
                    ? Optional.empty()
                    : Optional.of("has a pitch of " + item.param1() + " degrees; the cloud lets planes take off with "
                            + MissionCodec.TAKE_OFF_PITCH + ", set that.");
        }
        if (MissionCodec.isLanding(item) && item.command() != form.landing()) {
            return Optional.of(
                    form.kind() == VehicleKind.VTOL
                            ? "may land it as a plane; the cloud lets this vehicle land by NAV_VTOL_LAND only."
                            : "lands a vehicle that hovers; the cloud lets this vehicle land by NAV_LAND only.");
        }
        return hasMore(item)
                ? Optional.of("has settings that the cloud would lose; leave them empty.")
                : Optional.empty();
    }

    /** Whether there is more in an item than what it means to the cloud: settings, in the order of their numbers. */
    private static boolean hasMore(MissionItemInt item) {
        int read = switch (item.command()) {
            case MissionCodec.NAV_WAYPOINT, MissionCodec.DO_SET_ROI -> 1;
            case MissionCodec.DO_SET_SERVO -> 2;
            case MissionCodec.NAV_DELAY, MissionCodec.IMAGE_START_CAPTURE -> 4;
            default -> 0;
        };
        boolean landing = MissionCodec.isLanding(item) && item.param4() == CLOCKWISE;
        float[] settings = {item.param1(), item.param2(), item.param3(), landing ? 0 : item.param4()};
        for (int number = read; number < settings.length; number++) {
            if (!Float.isNaN(settings[number]) && settings[number] != 0) {
                return true;
            }
        }
        return false;
    }
}
