package org.dronemap.proxy.mavlink.translate;

import java.util.Optional;
import java.util.Set;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.HighLatency2;

/** Tells from MAV_TYPE whether a MAVLink component is a vehicle, and of what kind. */
public final class VehicleType {
    static final int FIXED_WING = 1;
    static final int QUADROTOR = 2;
    static final int COAXIAL = 3;
    static final int HELICOPTER = 4;
    static final int AIRSHIP = 7;
    static final int GROUND_ROVER = 10;
    static final int SURFACE_BOAT = 11;
    static final int SUBMARINE = 12;
    static final int VTOL_FIXED_ROTOR = 22;
    private static final int AUTOPILOT_INVALID = 8;
    private static final Set<Integer> OTHER_VEHICLES = Set.of(8, 9, 16, 17, 28, 45, 46);

    private VehicleType() {}

    /** True for the heartbeat of a vehicle's autopilot: no ground station, gimbal, camera, transponder, computer. */
    public static boolean isVehicle(Heartbeat heartbeat) {
        return heartbeat.autopilot() != AUTOPILOT_INVALID
                && (kind(heartbeat.type()) != VehicleKind.UNKNOWN || OTHER_VEHICLES.contains(heartbeat.type()));
    }

    /** The heartbeat that a frame is, or stands for; empty for a frame that is none and of what is no vehicle. */
    public static Optional<Heartbeat> announced(Frame frame) {
        Heartbeat heartbeat = switch (frame.messageId()) {
            case Heartbeat.ID -> Heartbeat.decode(frame);
            case HighLatency2.ID -> HighLatencyReader.heartbeat(HighLatency2.decode(frame), null);
            default -> null;
        };
        return Optional.ofNullable(heartbeat).filter(VehicleType::isVehicle);
    }

    static VehicleKind kind(int type) {
        return switch (type) {
            case FIXED_WING -> VehicleKind.FIXED_WING;
            case QUADROTOR, COAXIAL, 13, 14, 15, 29, 35, 43 -> VehicleKind.MULTICOPTER;
            case HELICOPTER -> VehicleKind.HELICOPTER;
            case AIRSHIP -> VehicleKind.AIRSHIP;
            case GROUND_ROVER -> VehicleKind.ROVER;
            case SURFACE_BOAT -> VehicleKind.BOAT;
            case SUBMARINE -> VehicleKind.SUBMARINE;
            case 19, 20, 21, 22, 23, 24, 25, 47 -> VehicleKind.VTOL;
            default -> VehicleKind.UNKNOWN;
        };
    }
}
