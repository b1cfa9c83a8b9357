package org.dronemap.ws.command;

import java.util.Optional;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItemFault;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ValueProblem;

/**
 * Rejects a mission by the member of the item that its vehicle does not fly as it is written, numbered as the client
 * wrote it; the gate judges the same for whoever else uploads missions.
 */
final class VehicleMissionCheck {
    private VehicleMissionCheck() {}

    static Mission checked(Mission mission, DroneState drone) {
        Optional<MissionItemFault> found = drone.capabilities().missions().fault(mission);
        if (found.isPresent()) {
            MissionItemFault fault = found.get();
            throw new InvalidInput(
                    ValueProblem.MISSION_UNUSABLE,
                    "items[" + fault.index() + "]." + fault.field(),
                    fault.allowed(),
                    fault.sentence(mission, drone.identification().vehicle()));
        }
        return mission;
    }
}
