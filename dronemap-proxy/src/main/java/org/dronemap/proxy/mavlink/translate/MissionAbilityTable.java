package org.dronemap.proxy.mavlink.translate;

import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.mission.MissionAbilities;
import org.dronemap.core.mission.MissionAbilities.Hold;
import org.dronemap.core.mission.MissionAbilities.Landing;
import org.dronemap.core.mission.MissionItem.Kind;

/**
 * The mission items that each kind of vehicle takes and flies as they are written. ArduPilot's firmwares share one
 * reader of items, which takes what the vehicle later skips with no more than a text, and cuts what it has no room for;
 * so what is left out here is what they would take and not do. Seen with ArduPilot 4.5.6.
 */
final class MissionAbilityTable {
    /** It goes along the ground. */
    private static final MissionAbilities GROUND = MissionAbilities.ALL.without(Kind.TAKE_OFF, Kind.LAND);

    private MissionAbilityTable() {}

    static MissionAbilities arduPilot(VehicleKind kind) {
        return switch (kind) {
            case MULTICOPTER, HELICOPTER -> MissionAbilities.ALL.with(Hold.WHOLE_SECONDS);
            // Plane never waits while it is armed, and keeps other values where the seconds would stand.
            case FIXED_WING ->
                MissionAbilities.ALL.without(Kind.WAIT).with(Hold.NONE).with(Landing.APPROACH);
            case VTOL -> MissionAbilities.ALL.without(Kind.WAIT).with(Hold.NONE);
            case ROVER, BOAT -> GROUND.with(Hold.WHOLE_SECONDS);
            case SUBMARINE -> MissionAbilities.ALL.without(Kind.TAKE_OFF).with(Hold.WHOLE_SECONDS);
            case AIRSHIP, UNKNOWN -> MissionAbilities.ALL;
        };
    }

    static MissionAbilities px4(VehicleKind kind) {
        return switch (kind) {
            case MULTICOPTER, HELICOPTER, AIRSHIP, UNKNOWN -> MissionAbilities.ALL;
            case FIXED_WING -> MissionAbilities.ALL.with(Landing.APPROACH);
            case VTOL -> MissionAbilities.ALL.with(Landing.AT_PLACE);
            case ROVER, BOAT -> GROUND;
            case SUBMARINE -> MissionAbilities.ALL.without(Kind.TAKE_OFF);
        };
    }
}
