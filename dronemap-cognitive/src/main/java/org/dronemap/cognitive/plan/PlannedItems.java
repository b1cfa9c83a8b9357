package org.dronemap.cognitive.plan;

import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.mission.MissionAbilities;
import org.dronemap.core.mission.MissionAbilities.Hold;
import org.dronemap.core.mission.MissionAbilities.Landing;
import org.dronemap.core.mission.MissionItem.Kind;

/**
 * Tells the mission items that plans use for a kind of vehicle: those that every firmware for it flies, since a plan
 * may be made before its drones are heard.
 */
final class PlannedItems {
    private PlannedItems() {}

    static MissionAbilities of(VehicleKind kind) {
        MissionAbilities exact = MissionAbilities.ALL.with(Hold.WHOLE_SECONDS);
        return switch (kind) {
            case MULTICOPTER, HELICOPTER, AIRSHIP, UNKNOWN -> exact;
            // An aeroplane needs its own way of coming down.
            case FIXED_WING ->
                MissionAbilities.ALL.without(Kind.WAIT, Kind.LAND).with(Hold.NONE);
            case VTOL -> MissionAbilities.ALL.without(Kind.WAIT).with(Hold.NONE).with(Landing.AT_PLACE);
            case ROVER, BOAT -> exact.without(Kind.TAKE_OFF, Kind.LAND);
            case SUBMARINE -> exact.without(Kind.TAKE_OFF);
        };
    }
}
