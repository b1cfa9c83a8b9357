package org.dronemap.proxy.session;

import java.util.List;
import java.util.Objects;
import java.util.function.Consumer;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionCurrent;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.proxy.mavlink.procedure.MavMissionType;
import org.dronemap.proxy.mavlink.procedure.MavlinkTarget;
import org.dronemap.proxy.mavlink.procedure.MissionDownload;
import org.dronemap.proxy.mavlink.procedure.MissionOpaqueId;
import org.dronemap.proxy.mavlink.translate.AutopilotAdapter;
import org.dronemap.proxy.mavlink.translate.MissionCodec;
import org.dronemap.proxy.mavlink.translate.VehicleStatus;
import org.dronemap.proxy.mavlink.translate.WireMissionItems;
import org.jspecify.annotations.Nullable;

/**
 * Keeps the cloud's copy of a vehicle's mission up to date: reads it at first, at hints of a change, and when idle.
 * Owned by the drone's lane.
 */
final class MissionWatch {
    private static final long BETWEEN_LOOKS_NANOS = 10_000_000_000L;
    private static final long AFTER_FAILURE_NANOS = 15_000_000_000L;
    private static final int LOOKS_BEFORE_READING = 3;
    /** So many items are read anew in one go; longer missions in parts of that many, one with each look. */
    private static final int CHEAP_ITEMS = 60;

    private static final int ITEMS_OF_A_LOOK = 20;

    private final MavlinkTarget target;
    private final AutopilotAdapter autopilot;
    private final VehicleStatus status;
    private final Consumer<DroneEvent> out;
    private final Consumer<List<MissionItemInt>> onRead;
    private final MissionIdTracker stamps = new MissionIdTracker();
    private @Nullable MissionDownload reading;
    private boolean readingWhole;
    private boolean wanted = true;
    private boolean disturbed;
    private boolean changedMeanwhile;
    private long nextNanos;
    private int looks;
    private int lookedUpTo;
    private @Nullable List<MissionItem> known;
    private @Nullable String knownHash;
    private int lastTotal = -1;

    /** {@code out} hears what the mission means, {@code onRead} each time what it is on the wire. */
    MissionWatch(
            MavlinkTarget target,
            AutopilotAdapter autopilot,
            VehicleStatus status,
            Consumer<DroneEvent> out,
            Consumer<List<MissionItemInt>> onRead) {
        this.onRead = onRead;
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
    void changedByCloud(MissionDownload readBack) {
        apply(readBack, true);
        wanted = false;
        disturbed = false;
    }

    /** {@code transferring}: a command has the mission protocol for itself. */
    void received(Frame frame, long nowNanos, boolean transferring) {
        if (transferring) {
            disturb();
            return;
        }
        boolean newStamp = stamps.isChangedBy(MissionOpaqueId.of(frame));
        boolean hinted = hintsAtChange(frame);
        boolean changed = newStamp || hinted;
        MissionDownload current = reading;
        if (current != null) {
            changedMeanwhile |= changed;
            current.received(frame, nowNanos);
            settle(current, nowNanos);
        } else if (changed || countsForAnybody(frame)) {
            wanted = true;
            nextNanos = Math.min(nextNanos, nowNanos);
        }
    }

    /** A vehicle that counts its items for somebody else may be about to get new ones. */
    private static boolean countsForAnybody(Frame frame) {
        return frame.messageId() == MissionCount.ID
                && MissionCount.decode(frame).missionType() == 0;
    }

    /** Nobody knows what a transfer leaves behind, unless it ends with a reading of its own. */
    private void disturb() {
        reading = null;
        disturbed = true;
    }

    private boolean hintsAtChange(Frame frame) {
        return switch (frame.messageId()) {
            case MissionAck.ID -> {
                MissionAck ack = MissionAck.decode(frame);
                yield ack.type() == 0 && ack.missionType() == 0;
            }
            case MissionCurrent.ID -> {
                int before = lastTotal;
                lastTotal = MissionCurrent.decode(frame).total();
                yield before >= 0 && before != lastTotal;
            }
            default -> false;
        };
    }

    void advance(long nowNanos, boolean transferring) {
        if (transferring) {
            disturb();
            nextNanos = nowNanos + BETWEEN_LOOKS_NANOS;
            return;
        }
        wanted |= disturbed;
        disturbed = false;
        MissionDownload current = reading;
        if (current != null) {
            current.advance(nowNanos);
            settle(current, nowNanos);
        } else if (nowNanos - nextNanos >= 0) {
            look(nowNanos);
        }
    }

    private void look(long nowNanos) {
        looks++;
        List<MissionItemInt> held = status.mission();
        boolean isLong = held != null && held.size() > CHEAP_ITEMS;
        boolean timeToRead = looks % LOOKS_BEFORE_READING == 0 && !isLong && !stamps.given();
        readingWhole = wanted || known == null || timeToRead;
        MissionDownload next;
        if (readingWhole) {
            next = MissionDownload.whole(target, MavMissionType.MISSION);
        } else if (isLong && !stamps.given()) {
            next = MissionDownload.part(target, MavMissionType.MISSION, lookedUpTo, ITEMS_OF_A_LOOK);
        } else {
            next = MissionDownload.count(target, MavMissionType.MISSION);
        }
        reading = next;
        changedMeanwhile = false;
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
            apply(current, false);
        } else if (!isAsHeld(current)) {
            wanted = true;
            nextNanos = nowNanos;
        }
        if (changedMeanwhile) {
            // What was read may be part old, part new.
            wanted = true;
            nextNanos = nowNanos;
        }
    }

    /** As many items as known, and those that were read the same. */
    private boolean isAsHeld(MissionDownload seen) {
        List<MissionItemInt> held = status.mission();
        if (held == null || seen.count() != held.size()) {
            return false;
        }
        int first = lookedUpTo;
        lookedUpTo = first + seen.items().size() >= held.size()
                ? 0
                : first + seen.items().size();
        for (int index = 0; index < seen.items().size(); index++) {
            boolean own = first + index >= autopilot.itemsBeforeMission();
            if (own
                    && !WireMissionItems.same(
                            held.get(first + index), seen.items().get(index))) {
                return false;
            }
        }
        return true;
    }

    private void apply(MissionDownload read, boolean asUploaded) {
        List<MissionItem> mission = MissionCodec.fromWire(read.items(), autopilot.itemsBeforeMission());
        String hash = read.isExact() ? WireMissionItems.hash(read.items(), autopilot.itemsBeforeMission()) : null;
        stamps.read(read.stamp());
        lookedUpTo = 0;
        status.missionRead(read.items());
        onRead.accept(read.items());
        boolean changed = !mission.equals(known) || !Objects.equals(hash, knownHash);
        if (asUploaded || (known != null && changed)) {
            status.missionReplaced();
        }
        if (asUploaded || changed) {
            known = mission;
            knownHash = hash;
            out.accept(new DroneEvent.MissionRead(
                    mission, hash, asUploaded, MissionCodec.hasLandingSequence(read.items())));
        }
    }
}
