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
import org.dronemap.mavlink.message.MissionWritePartialList;

/** A vehicle's side of the mission protocol that keeps its old mission until the new one is whole; parts go in place. */
public final class MissionVehicle {
    public List<MissionItemInt> held = new ArrayList<>();
    /** Answers to a part that it does not take. */
    public boolean refusesParts;

    private int partFrom = -1;
    private int partTo = -1;
    private final Map<Integer, MissionItemInt> arriving = new TreeMap<>();
    private int expected = -1;

    public void take(TestWire wire, Message message) {
        if (message instanceof MissionWritePartialList part) {
            takePart(wire, part);
        } else if (message instanceof MissionCount count) {
            expected = count.count();
            partFrom = -1;
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

    private void takePart(TestWire wire, MissionWritePartialList part) {
        if (refusesParts) {
            wire.answer(new MissionAck(255, 190, 3, part.missionType()));
            return;
        }
        partFrom = part.startIndex();
        partTo = part.endIndex();
        wire.answer(new MissionRequestInt(255, 190, partFrom, part.missionType()));
    }

    private void takeItem(TestWire wire, MissionItemInt item) {
        if (partFrom >= 0 && partFrom <= partTo) {
            if (item.seq() == partFrom) {
                held.set(item.seq(), item);
                partFrom++;
            }
            wire.answer(
                    partFrom > partTo
                            ? new MissionAck(255, 190, 0, item.missionType())
                            : new MissionRequestInt(255, 190, partFrom, item.missionType()));
            return;
        }
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
