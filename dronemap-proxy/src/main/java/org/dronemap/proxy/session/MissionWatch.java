package org.dronemap.proxy.session;

import java.util.List;
import java.util.function.Consumer;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionCurrent;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.proxy.mavlink.procedure.MissionDownload;
import org.dronemap.proxy.mavlink.procedure.MissionKind;
import org.dronemap.proxy.mavlink.procedure.Target;
import org.dronemap.proxy.mavlink.translate.Autopilot;
import org.dronemap.proxy.mavlink.translate.MissionCodec;
import org.dronemap.proxy.mavlink.translate.VehicleStatus;
import org.jspecify.annotations.Nullable;

/**
 * Keeps in step with the mission on a vehicle, whoever put it there: reads it at first, when something hints at a
 * change, and looks again while nothing else is going on. Owned by the drone's lane.
 */
final class MissionWatch {
    private static final long BETWEEN_LOOKS_NANOS = 10_000_000_000L;
    private static final long AFTER_FAILURE_NANOS = 15_000_000_000L;
    private static final int LOOKS_BEFORE_READING = 3;
    private static final int CHEAP_ITEMS = 60;

    private final Target target;
    private final Autopilot autopilot;
    private final VehicleStatus status;
    private final Consumer<DroneEvent> out;
    private @Nullable MissionDownload reading;
    private boolean readingWhole;
    private boolean wanted = true;
    private long nextNanos;
    private int looks;
    private @Nullable List<MissionItem> known;
    private int knownWireItems = -1;
    private int lastTotal = -1;

    MissionWatch(Target target, Autopilot autopilot, VehicleStatus status, Consumer<DroneEvent> out) {
        this.target = target;
        this.autopilot = autopilot;
        this.status = status;
        this.out = out;
    }

    /** A drone that knows nothing yet listens from now on. */
    void begin(long nowNanos) {
        known = null;
        wanted = true;
        nextNanos = nowNanos;
    }

    /** The cloud itself changed the mission and read it back. */
    void changedByCloud(List<MissionItemInt> items) {
        take(items, true);
        wanted = false;
    }

    /** {@code transferring}: a command has the mission protocol for itself. */
    void heard(Frame frame, long nowNanos, boolean transferring) {
        if (transferring) {
            reading = null;
            return;
        }
        MissionDownload current = reading;
        if (current != null) {
            current.heard(frame, nowNanos);
            settle(current, nowNanos);
        } else if (hintsAtChange(frame)) {
            wanted = true;
            nextNanos = Math.min(nextNanos, nowNanos);
        }
    }

    private boolean hintsAtChange(Frame frame) {
        return switch (frame.messageId()) {
            case MissionAck.ID -> {
                MissionAck ack = MissionAck.decode(frame);
                yield ack.type() == 0 && ack.missionType() == 0;
            }
            case MissionCount.ID -> MissionCount.decode(frame).missionType() == 0;
            case MissionCurrent.ID -> {
                int before = lastTotal;
                lastTotal = MissionCurrent.decode(frame).total();
                yield before >= 0 && before != lastTotal;
            }
            default -> false;
        };
    }

    void tick(long nowNanos, boolean transferring) {
        if (transferring) {
            reading = null;
            nextNanos = nowNanos + BETWEEN_LOOKS_NANOS;
            return;
        }
        MissionDownload current = reading;
        if (current != null) {
            current.tick(nowNanos);
            settle(current, nowNanos);
        } else if (nowNanos - nextNanos >= 0) {
            read(nowNanos);
        }
    }

    private void read(long nowNanos) {
        looks++;
        boolean timeToRead = looks % LOOKS_BEFORE_READING == 0 && knownWireItems <= CHEAP_ITEMS;
        readingWhole = wanted || known == null || timeToRead;
        MissionDownload next = readingWhole
                ? MissionDownload.whole(target, MissionKind.MISSION)
                : MissionDownload.count(target, MissionKind.MISSION);
        reading = next;
        next.start(nowNanos);
    }

    private void settle(MissionDownload current, long nowNanos) {
        Outcome outcome = current.outcome();
        if (outcome == null) {
            return;
        }
        reading = null;
        if (!(outcome instanceof Outcome.Succeeded)) {
            nextNanos = nowNanos + AFTER_FAILURE_NANOS;
            return;
        }
        nextNanos = nowNanos + BETWEEN_LOOKS_NANOS;
        if (readingWhole) {
            wanted = false;
            take(current.items(), false);
        } else if (current.count() != knownWireItems) {
            wanted = true;
            nextNanos = nowNanos;
        }
    }

    private void take(List<MissionItemInt> items, boolean asUploaded) {
        List<MissionItem> mission = MissionCodec.fromWire(items, autopilot.itemsBeforeMission());
        knownWireItems = items.size();
        status.missionRead(items.size());
        if (asUploaded || !mission.equals(known)) {
            known = mission;
            out.accept(new DroneEvent.MissionRead(mission, asUploaded));
        }
    }
}
