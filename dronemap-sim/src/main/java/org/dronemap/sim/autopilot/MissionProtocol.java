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
import org.dronemap.mavlink.message.MissionWritePartialList;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.SimulatedMission;
import org.dronemap.sim.flight.SimulatedMissionItem;
import org.dronemap.sim.flight.TextSeverity;

/** A simulated vehicle's side of the MAVLink mission protocol: upload, download, clear. Milliseconds. */
final class MissionProtocol {
    private static final int FENCE = 1;
    private static final int RALLY = 2;
    private static final int ACCEPTED = 0;
    private static final int ERROR = 1;
    private static final int UNSUPPORTED = 3;
    private static final int NO_SPACE = 4;
    private static final int INVALID_SEQUENCE = 13;
    private static final int DENIED = 14;
    private static final int CANCELLED = 15;

    private final SimulatedAutopilot autopilot;
    private final MissionProtocolStyle style;
    private final SimulatedMission plan;
    private final SimulatedStorageFaults alterations;
    private final Consumer<Message> out;
    private final Consumer<FlightEvent> events;
    private final FenceRallyProtocol fence;
    private final FenceRallyProtocol rally;
    private final List<SimulatedMissionItem> arriving = new ArrayList<>();
    private boolean receiving;
    private int expected;
    private int total;
    private int peerSystem;
    private int peerComponent;
    private long lastItemAt;
    private long askedAt;

    MissionProtocol(
            SimulatedAutopilot autopilot,
            SimulatedStorageFaults alterations,
            Consumer<Message> out,
            Consumer<FlightEvent> events) {
        this.autopilot = autopilot;
        this.alterations = alterations;
        this.style = autopilot.missionStyle();
        this.plan = autopilot.plan();
        this.out = out;
        this.events = events;
        this.fence = new FenceRallyProtocol(FENCE, autopilot.fence(), style.asksWithRequestInt(), out);
        this.rally = new FenceRallyProtocol(RALLY, autopilot.rallyPoints(), style.asksWithRequestInt(), out);
    }

    private FenceRallyProtocol plain(int missionType) {
        return missionType == FENCE ? fence : rally;
    }

    private static boolean isPlain(int missionType) {
        return missionType == FENCE || missionType == RALLY;
    }

    void step(long nowMillis) {
        fence.step(nowMillis);
        rally.step(nowMillis);
        if (!receiving) {
            return;
        }
        if (nowMillis - lastItemAt >= style.giveUpMillis()) {
            receiving = false;
            acknowledge(CANCELLED, 0);
            sendText(TextSeverity.WARNING, "Mission upload timeout");
        } else if (nowMillis - askedAt >= style.askAgainMillis()) {
            ask(nowMillis);
        }
    }

    void count(MissionCount message, int fromSystem, int fromComponent, long nowMillis) {
        if (isPlain(message.missionType())) {
            plain(message.missionType()).count(message, fromSystem, fromComponent, nowMillis);
            return;
        }
        if (receiving && fromSystem != peerSystem) {
            out.accept(new MissionAck(fromSystem, fromComponent, DENIED, message.missionType()));
            return;
        }
        peerSystem = fromSystem;
        peerComponent = fromComponent;
        if (message.missionType() != 0) {
            acknowledge(message.count() == 0 ? ACCEPTED : UNSUPPORTED, message.missionType());
            return;
        }
        if (message.count() > style.maxItems()) {
            acknowledge(NO_SPACE, 0);
            sendText(TextSeverity.WARNING, "Only " + style.maxItems() + " items are supported");
            return;
        }
        total = message.count();
        expected = 0;
        arriving.clear();
        if (style.overwritesInPlace()) {
            plan.truncate(total);
        }
        receiving = true;
        lastItemAt = nowMillis;
        if (total == 0) {
            finish();
        } else {
            ask(nowMillis);
        }
    }

    /** Only ArduPilot takes a part, and only of items that it has; what it has beside them stays. */
    void writePart(MissionWritePartialList message, int fromSystem, int fromComponent, long nowMillis) {
        if (!style.overwritesInPlace() || message.missionType() != 0) {
            return;
        }
        if (receiving && fromSystem != peerSystem) {
            out.accept(new MissionAck(fromSystem, fromComponent, DENIED, 0));
            return;
        }
        peerSystem = fromSystem;
        peerComponent = fromComponent;
        int first = message.startIndex();
        int last = message.endIndex();
        if (first < 0 || last < first || last >= plan.size()) {
            acknowledge(ERROR, 0);
            sendText(TextSeverity.WARNING, "Flight plan update rejected");
            return;
        }
        expected = first;
        total = last + 1;
        receiving = true;
        lastItemAt = nowMillis;
        ask(nowMillis);
    }

    private void ask(long nowMillis) {
        askedAt = nowMillis;
        out.accept(
                style.asksWithRequestInt()
                        ? new MissionRequestInt(peerSystem, peerComponent, expected, 0)
                        : new MissionRequest(peerSystem, peerComponent, expected, 0));
    }

    void item(MissionItemInt message, int fromSystem, long nowMillis) {
        if (isPlain(message.missionType())) {
            plain(message.missionType()).item(message, fromSystem, nowMillis);
            return;
        }
        if (!receiving || fromSystem != peerSystem || message.missionType() != 0) {
            return;
        }
        if (message.seq() != expected) {
            // An item that came twice is no reason to give up: PX4 overlooks it, ArduPilot complains and waits on.
            if (style.overwritesInPlace()) {
                acknowledge(INVALID_SEQUENCE, 0);
            } else if (message.seq() == expected - 1) {
                ask(nowMillis);
            }
            return;
        }
        SimulatedMissionItem item = MissionItemMessages.read(message);
        int wrong = autopilot.missionItems().judge(item, total - 1);
        if (wrong != ACCEPTED && !(expected == 0 && style.firstItemIsHome())) {
            receiving = false;
            acknowledge(wrong, 0);
            return;
        }
        keep(item);
        lastItemAt = nowMillis;
        expected++;
        if (expected == total) {
            finish();
        } else {
            ask(nowMillis);
        }
    }

    private void keep(SimulatedMissionItem item) {
        if (!style.overwritesInPlace()) {
            arriving.add(kept(item));
        } else if (expected == 0 && style.firstItemIsHome()) {
            plan.put(0, SimulatedMissionItem.home(autopilot.craft().home()));
        } else {
            plan.put(expected, kept(item));
        }
    }

    private SimulatedMissionItem kept(SimulatedMissionItem item) {
        SimulatedMissionItem kept = autopilot.missionItems().keep(item);
        return kept.with(kept.frame(), alterations.keptAltitude(expected, kept.z()));
    }

    private void finish() {
        receiving = false;
        if (!style.overwritesInPlace()) {
            plan.replaceAll(arriving);
        }
        autopilot.missionChanged();
        acknowledge(ACCEPTED, 0);
        sendText(TextSeverity.INFO, "Flight plan received");
    }

    void sendCount(int missionType, int toSystem, int toComponent) {
        if (isPlain(missionType)) {
            plain(missionType).sendCount(toSystem, toComponent);
            return;
        }
        if (receiving && missionType == 0) {
            out.accept(new MissionAck(toSystem, toComponent, DENIED, missionType));
            return;
        }
        out.accept(new MissionCount(toSystem, toComponent, missionType == 0 ? plan.size() : 0, missionType));
    }

    void sendItem(MissionRequestInt request, boolean inFloats, int toSystem, int toComponent) {
        int index = request.seq();
        int missionType = request.missionType();
        if (isPlain(missionType)) {
            plain(missionType).sendItem(index, toSystem, toComponent);
            return;
        }
        if (missionType != 0 || index >= plan.size()) {
            out.accept(new MissionAck(toSystem, toComponent, DENIED, missionType));
            return;
        }
        SimulatedMissionItem item = index == 0 && style.firstItemIsHome()
                ? SimulatedMissionItem.home(autopilot.craft().home())
                : plan.item(index);
        MissionItemInt message =
                MissionItemMessages.write(item, new MissionItemMessages.Address(index, 0, toSystem, toComponent));
        if (inFloats && style.overwritesInPlace()) {
            sendText(TextSeverity.WARNING, "got MISSION_REQUEST; use MISSION_REQUEST_INT!");
        }
        out.accept(inFloats ? FloatMissionItems.of(message) : message);
    }

    void clear(int missionType, int toSystem, int toComponent) {
        if (isPlain(missionType)) {
            plain(missionType).clear(toSystem, toComponent);
            return;
        }
        boolean may = missionType != 0 || autopilot.mayClearMission();
        if (may && (missionType == 0 || missionType == 255)) {
            plan.clear();
            autopilot.missionChanged();
            receiving = false;
        }
        out.accept(new MissionAck(toSystem, toComponent, may ? ACCEPTED : ERROR, missionType));
    }

    private void acknowledge(int type, int missionType) {
        out.accept(new MissionAck(peerSystem, peerComponent, type, missionType));
    }

    private void sendText(TextSeverity severity, String text) {
        if (style.speaks()) {
            events.accept(new FlightEvent.Text(severity, text));
        }
    }
}
