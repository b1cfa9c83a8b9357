package org.dronemap.proxy.mavlink.procedure;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionClearAll;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionRequestInt;
import org.dronemap.mavlink.message.MissionRequestList;

/** A vehicle's side of the mission protocol that keeps its old mission until the new one is whole. */
final class MissionVehicle {
    List<MissionItemInt> held = new ArrayList<>();
    private final Map<Integer, MissionItemInt> arriving = new TreeMap<>();
    private int expected = -1;

    void take(Wire wire, Message message) {
        if (message instanceof MissionCount count) {
            expected = count.count();
            arriving.clear();
            wire.answer(new MissionRequestInt(255, 190, 0, count.missionType()));
        } else if (message instanceof MissionItemInt item) {
            takeItem(wire, item);
        } else if (message instanceof MissionRequestList list) {
            wire.answer(new MissionCount(255, 190, held.size(), list.missionType()));
        } else if (message instanceof MissionRequestInt request && request.seq() < held.size()) {
            wire.answer(held.get(request.seq()));
        } else if (message instanceof MissionClearAll clear) {
            held = new ArrayList<>();
            wire.answer(new MissionAck(255, 190, 0, clear.missionType()));
        }
    }

    private void takeItem(Wire wire, MissionItemInt item) {
        if (expected < 0) {
            return;
        }
        if (item.seq() == arriving.size()) {
            arriving.put(item.seq(), item);
        }
        if (arriving.size() < expected) {
            wire.answer(new MissionRequestInt(255, 190, arriving.size(), item.missionType()));
        } else {
            held = new ArrayList<>(arriving.values());
            expected = -1;
            wire.answer(new MissionAck(255, 190, 0, item.missionType()));
        }
    }
}
