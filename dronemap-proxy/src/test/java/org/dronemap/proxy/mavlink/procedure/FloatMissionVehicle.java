package org.dronemap.proxy.mavlink.procedure;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItem;
import org.dronemap.mavlink.message.MissionRequest;
import org.dronemap.mavlink.message.MissionRequestList;

/** A vehicle that knows missions in floating point alone, as those of years ago. */
public final class FloatMissionVehicle {
    public List<MissionItem> held = new ArrayList<>();
    private List<MissionItem> arriving = new ArrayList<>();
    private int expected = -1;

    public void take(TestWire wire, Message message) {
        if (message instanceof MissionCount count) {
            expected = count.count();
            arriving = new ArrayList<>();
            wire.answer(new MissionRequest(255, 190, 0, count.missionType()));
        } else if (message instanceof MissionItem item && item.seq() == arriving.size() && expected > 0) {
            arriving.add(item);
            if (arriving.size() == expected) {
                held = arriving;
                expected = -1;
                wire.answer(new MissionAck(255, 190, 0, item.missionType()));
            } else {
                wire.answer(new MissionRequest(255, 190, arriving.size(), item.missionType()));
            }
        } else if (message instanceof MissionRequestList list) {
            wire.answer(new MissionCount(255, 190, held.size(), list.missionType()));
        } else if (message instanceof MissionRequest request && request.seq() < held.size()) {
            wire.answer(held.get(request.seq()));
        }
    }
}
