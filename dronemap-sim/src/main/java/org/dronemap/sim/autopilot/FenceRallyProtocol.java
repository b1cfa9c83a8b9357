package org.dronemap.sim.autopilot;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionRequest;
import org.dronemap.mavlink.message.MissionRequestInt;
import org.dronemap.sim.flight.SimulatedMissionItem;

/** A simulated vehicle's side of fence and rally point transfers, which are stored whole or not at all. */
final class FenceRallyProtocol {
    private static final int INVALID = 5;
    private static final int MOST = 254;
    private static final long ASK_AGAIN_MILLIS = 1_000;
    private static final long GIVE_UP_MILLIS = 8_000;

    private final int missionType;
    private final FenceStorage storage;
    private final boolean asksWithRequestInt;
    private final Consumer<Message> out;
    private final List<SimulatedMissionItem> arriving = new ArrayList<>();
    private int total = -1;
    private int peerSystem;
    private int peerComponent;
    private long lastItemAt;
    private long askedAt;

    FenceRallyProtocol(int missionType, FenceStorage storage, boolean asksWithRequestInt, Consumer<Message> out) {
        this.missionType = missionType;
        this.storage = storage;
        this.asksWithRequestInt = asksWithRequestInt;
        this.out = out;
    }

    void step(long nowMillis) {
        if (total >= 0 && nowMillis - lastItemAt >= GIVE_UP_MILLIS) {
            total = -1;
        } else if (total >= 0 && nowMillis - askedAt >= ASK_AGAIN_MILLIS) {
            ask(nowMillis);
        }
    }

    void count(MissionCount message, int fromSystem, int fromComponent, long nowMillis) {
        peerSystem = fromSystem;
        peerComponent = fromComponent;
        arriving.clear();
        lastItemAt = nowMillis;
        if (message.count() > MOST) {
            acknowledge(INVALID);
        } else if (message.count() == 0) {
            clear(fromSystem, fromComponent);
        } else {
            total = message.count();
            ask(nowMillis);
        }
    }

    void item(MissionItemInt item, int fromSystem, long nowMillis) {
        if (total < 0 || fromSystem != peerSystem) {
            return;
        }
        if (item.seq() == arriving.size()) {
            SimulatedMissionItem read = MissionItemMessages.read(item);
            int judged = storage.judge(read);
            if (judged != FenceStorage.ACCEPTED) {
                total = -1;
                acknowledge(judged);
                return;
            }
            arriving.add(read);
            lastItemAt = nowMillis;
        }
        if (arriving.size() < total) {
            ask(nowMillis);
        } else {
            total = -1;
            acknowledge(storage.store(List.copyOf(arriving)));
        }
    }

    void sendCount(int toSystem, int toComponent) {
        out.accept(new MissionCount(toSystem, toComponent, storage.items().size(), missionType));
    }

    void sendItem(int seq, int toSystem, int toComponent) {
        if (seq >= storage.items().size()) {
            out.accept(new MissionAck(toSystem, toComponent, INVALID, missionType));
            return;
        }
        out.accept(MissionItemMessages.write(
                storage.items().get(seq), new MissionItemMessages.Address(seq, missionType, toSystem, toComponent)));
    }

    void clear(int toSystem, int toComponent) {
        total = -1;
        out.accept(new MissionAck(toSystem, toComponent, storage.store(List.of()), missionType));
    }

    private void ask(long nowMillis) {
        askedAt = nowMillis;
        out.accept(
                asksWithRequestInt
                        ? new MissionRequestInt(peerSystem, peerComponent, arriving.size(), missionType)
                        : new MissionRequest(peerSystem, peerComponent, arriving.size(), missionType));
    }

    private void acknowledge(int type) {
        out.accept(new MissionAck(peerSystem, peerComponent, type, missionType));
    }
}
