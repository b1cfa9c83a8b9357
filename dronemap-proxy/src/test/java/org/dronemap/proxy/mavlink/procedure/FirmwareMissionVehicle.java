package org.dronemap.proxy.mavlink.procedure;

import java.util.Set;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionItemInt;

/** A vehicle of ArduPilot that takes and keeps mission items as the firmware's one reader of items does. */
public final class FirmwareMissionVehicle {
    private static final int MISSION_FRAME = 2;
    private static final int WAYPOINT = 16;
    private static final int LAND = 21;
    private static final Set<Integer> KNOWN = Set.of(16, 20, 21, 22, 84, 85, 93, 178, 183, 189, 201, 203, 2000);
    private static final Set<Integer> PLACED = Set.of(16, 21, 22, 84, 85, 189, 201);

    public final MissionVehicle memory = new MissionVehicle();
    private final boolean plane;

    public FirmwareMissionVehicle(boolean plane) {
        this.plane = plane;
    }

    public void take(TestWire wire, Message message) {
        if (!(message instanceof MissionItemInt item)) {
            memory.take(wire, message);
        } else if (!KNOWN.contains(item.command())) {
            wire.answer(new MissionAck(255, 190, 3, item.missionType()));
        } else {
            memory.take(wire, kept(item));
        }
    }

    /** What it has room for: whole seconds of a waypoint, of a plane no seconds at all. */
    private MissionItemInt kept(MissionItemInt item) {
        boolean waypoint = item.command() == WAYPOINT;
        boolean placed = PLACED.contains(item.command());
        float first = waypoint ? (plane ? 0 : (int) item.param1()) : item.param1();
        return new MissionItemInt(
                item.targetSystem(),
                item.targetComponent(),
                item.seq(),
                placed && item.frame() != MISSION_FRAME ? item.frame() : 0,
                item.command(),
                item.current(),
                item.autocontinue(),
                first,
                waypoint ? 0 : item.param2(),
                waypoint ? 0 : item.param3(),
                item.command() == LAND ? 1 : waypoint ? 0 : item.param4(),
                item.x(),
                item.y(),
                (int) (item.z() * 100) / 100f,
                item.missionType());
    }
}
