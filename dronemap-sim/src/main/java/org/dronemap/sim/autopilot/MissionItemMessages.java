package org.dronemap.sim.autopilot;

import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.sim.flight.SimulatedMissionItem;

/** Converts mission, fence and rally items of a simulated vehicle to and from MAVLink messages. */
final class MissionItemMessages {
    private MissionItemMessages() {}

    /** To whom, and what it is the {@code seq}-th of. */
    record Address(int seq, int missionType, int toSystem, int toComponent) {}

    static SimulatedMissionItem read(MissionItemInt message) {
        return new SimulatedMissionItem(
                message.command(),
                message.frame(),
                message.autocontinue(),
                message.param1(),
                message.param2(),
                message.param3(),
                message.param4(),
                message.x(),
                message.y(),
                message.z());
    }

    static MissionItemInt write(SimulatedMissionItem item, Address address) {
        return new MissionItemInt(
                address.toSystem(),
                address.toComponent(),
                address.seq(),
                item.frame(),
                item.command(),
                0,
                item.autocontinue(),
                item.param1(),
                item.param2(),
                item.param3(),
                item.param4(),
                item.x(),
                item.y(),
                item.z(),
                address.missionType());
    }
}
