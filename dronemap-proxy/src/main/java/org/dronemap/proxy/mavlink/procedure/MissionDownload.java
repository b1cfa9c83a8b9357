package org.dronemap.proxy.mavlink.procedure;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.command.Outcome;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItem;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionRequest;
import org.dronemap.mavlink.message.MissionRequestInt;
import org.dronemap.mavlink.message.MissionRequestList;
import org.jspecify.annotations.Nullable;

/**
 * Reads the mission of a vehicle (or its fence, or rally points): list, count, each item in order, thanks; goes on where
 * it was after a break of the link. Vehicles without integer items are heard too.
 */
public final class MissionDownload implements Exchange {
    private static final long LEAST_PAUSE_NANOS = 500_000_000L;
    private static final int MOST_ITEMS = 2_000;

    private final Target target;
    private final MissionKind kind;
    private final boolean countOnly;
    private final Patience patience = new Patience();
    private final List<MissionItemInt> items = new ArrayList<>();
    private int count = -1;
    private Pace pace = new Pace(0, 0, 0);
    private int tries;
    private long lastSentNanos;
    private @Nullable Outcome outcome;

    private MissionDownload(Target target, MissionKind kind, boolean countOnly) {
        this.target = target;
        this.kind = kind;
        this.countOnly = countOnly;
    }

    public static MissionDownload whole(Target target, MissionKind kind) {
        return new MissionDownload(target, kind, false);
    }

    /** Only asks how many items there are. */
    public static MissionDownload count(Target target, MissionKind kind) {
        return new MissionDownload(target, kind, true);
    }

    /** What was read so far, home included where the autopilot keeps it as item 0. */
    public List<MissionItemInt> items() {
        return items;
    }

    /** How many items the vehicle said it has; -1 before. */
    public int count() {
        return count;
    }

    @Override
    public void start(long nowNanos) {
        pace = Pace.of(target.roundTrip(), 0);
        patience.begin(nowNanos);
        ask(nowNanos);
    }

    @Override
    public void heard(Frame frame, long nowNanos) {
        if (outcome != null) {
            return;
        }
        patience.heard(nowNanos);
        switch (frame.messageId()) {
            case MissionCount.ID -> counted(MissionCount.decode(frame), nowNanos);
            case MissionItemInt.ID -> took(MissionItemInt.decode(frame), nowNanos);
            case MissionItem.ID -> took(exact(MissionItem.decode(frame)), nowNanos);
            case MissionAck.ID -> refused(MissionAck.decode(frame));
            default -> {}
        }
    }

    @Override
    public void tick(long nowNanos) {
        if (outcome != null || nowNanos - lastSentNanos < Math.max(LEAST_PAUSE_NANOS, pace.pauseNanos(tries))) {
            return;
        }
        outcome = patience.end(nowNanos);
        if (outcome == null) {
            ask(nowNanos);
        }
    }

    @Override
    public @Nullable Outcome outcome() {
        return outcome;
    }

    private void ask(long nowNanos) {
        int system = target.systemId();
        int component = target.componentId();
        if (count < 0) {
            target.send(new MissionRequestList(system, component, kind.number()));
        } else if (tries % 3 == 2) {
            // Old vehicles know only the request for an item with floating-point position.
            target.send(new MissionRequest(system, component, items.size(), kind.number()));
        } else {
            target.send(new MissionRequestInt(system, component, items.size(), kind.number()));
        }
        patience.asked(nowNanos);
        tries++;
        lastSentNanos = nowNanos;
    }

    private void counted(MissionCount message, long nowNanos) {
        if (count >= 0 || message.missionType() != kind.number() || !Target.isForUs(message.targetSystem())) {
            return;
        }
        if (message.count() > MOST_ITEMS) {
            outcome = new Outcome.Failed("The vehicle says it has " + message.count() + " mission items.");
            return;
        }
        count = message.count();
        next(nowNanos);
    }

    private void took(MissionItemInt item, long nowNanos) {
        if (count < 0 || item.missionType() != kind.number() || item.seq() != items.size()) {
            return;
        }
        items.add(item);
        next(nowNanos);
    }

    private void next(long nowNanos) {
        patience.news(nowNanos);
        if (countOnly || items.size() == count) {
            target.send(new MissionAck(target.systemId(), target.componentId(), 0, kind.number()));
            outcome = new Outcome.Succeeded();
        } else {
            tries = 0;
            ask(nowNanos);
        }
    }

    /** A refusal in the middle means that somebody else has changed the mission: begin again. */
    private void refused(MissionAck ack) {
        if (ack.missionType() == kind.number() && ack.type() != 0 && Target.isForUs(ack.targetSystem())) {
            if (count < 0) {
                outcome = new Outcome.Refused("vehicle", MissionResult.words(ack.type()));
            } else {
                count = -1;
                items.clear();
            }
        }
    }

    private static MissionItemInt exact(MissionItem item) {
        return new MissionItemInt(
                item.targetSystem(),
                item.targetComponent(),
                item.seq(),
                item.frame(),
                item.command(),
                item.current(),
                item.autocontinue(),
                item.param1(),
                item.param2(),
                item.param3(),
                item.param4(),
                (int) Math.round(item.x() * 1e7),
                (int) Math.round(item.y() * 1e7),
                item.z(),
                item.missionType());
    }
}
