package org.dronemap.proxy.mavlink.procedure;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionRequest;

/** Takes a mission as ArduPilot does: asks again by its own clock, and complains of what it has not asked for. */
final class ReRequestingMissionVehicle {
    private static final long ASKS_AGAIN_NANOS = 1_000_000_000L;
    private static final int INVALID_SEQUENCE = 13;

    final List<MissionItemInt> held = new ArrayList<>();
    private int total = -1;
    private long askedNanos;

    void take(TestWire wire, Message message) {
        if (message instanceof MissionCount count) {
            total = count.count();
            held.clear();
            ask(wire);
        } else if (message instanceof MissionItemInt item && total >= 0) {
            take(wire, item);
        }
    }

    private void take(TestWire wire, MissionItemInt item) {
        if (item.seq() != held.size()) {
            wire.answer(new MissionAck(255, 190, INVALID_SEQUENCE, 0));
            return;
        }
        held.add(item);
        if (held.size() < total) {
            ask(wire);
        } else {
            total = -1;
            wire.answer(new MissionAck(255, 190, 0, 0));
        }
    }

    void tick(TestWire wire) {
        if (total >= 0 && wire.now() - askedNanos >= ASKS_AGAIN_NANOS) {
            ask(wire);
        }
    }

    private void ask(TestWire wire) {
        askedNanos = wire.now();
        wire.answer(new MissionRequest(255, 190, held.size(), 0));
    }
}
