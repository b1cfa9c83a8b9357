package org.dronemap.core.safety;

import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.CloudLossAction;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.drone.VehicleKind;
import org.jspecify.annotations.Nullable;

/** Ending of a commanded return: the drone lands at home, circles there, or that is not known. Pure. */
public enum ReturnEnding {
    /** It lands, as most do. */
    LANDS,
    /** It lands by the landing sequence of its mission. */
    LANDS_BY_MISSION,
    /** It has no landing sequence on board: it circles above its home until somebody lands it. */
    CIRCLES,
    /** It lands by its mission alone, and that was not read. */
    NOT_KNOWN;

    /**
     * A fixed wing that cannot be told to land where it is needs a runway, which nothing but a landing sequence of its mission
     * tells it.
     *
     * @param action what it does by itself, as its parameters say; null: not known
     */
    public static ReturnEnding of(DroneState drone, @Nullable CloudLossAction action) {
        if (!needsSequence(drone) || (action != null && action.atHome() == CloudLossAction.AtHome.BY_ITSELF)) {
            return LANDS;
        }
        MissionProgress mission = drone.mission();
        if (mission.items() == null) {
            return NOT_KNOWN;
        }
        return mission.landingSequence() ? LANDS_BY_MISSION : CIRCLES;
    }

    private static boolean needsSequence(DroneState drone) {
        return drone.identification().kind() == VehicleKind.FIXED_WING
                && drone.capabilities().commands().contains(Capability.RETURN_TO_LAUNCH)
                && !drone.capabilities().commands().contains(Capability.LAND);
    }
}
