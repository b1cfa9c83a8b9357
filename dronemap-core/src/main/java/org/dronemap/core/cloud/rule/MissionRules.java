package org.dronemap.core.cloud.rule;

import java.util.Optional;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.mission.Mission;

/** Rules by which what a drone takes in missions allows or forbids one; asked before anything of it is sent. */
public final class MissionRules {
    private MissionRules() {}

    /** Why the drone does not fly this mission as it is written; empty when it does, as far as is known. */
    public static Optional<Refusal> whyNot(DroneState drone, Mission mission) {
        return drone.capabilities()
                .missions()
                .fault(mission)
                .map(fault -> new Refusal(
                        OutcomeCode.MISSION_NOT_FOR_VEHICLE,
                        fault.sentence(mission, drone.identification().vehicle())));
    }
}
