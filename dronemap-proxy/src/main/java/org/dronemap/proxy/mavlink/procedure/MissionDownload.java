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
 * Downloads the mission, fence or rally points of a vehicle, whole or in part; resumes after a break of the link.
 * Vehicles without integer items are heard too.
 */
public final class MissionDownload implements Exchange {
    private static final long LEAST_PAUSE_NANOS = 500_000_000L;
    private static final int MOST_ITEMS = 2_000;
    /** Who answered so many questions for an integer item with nothing may know floating-point ones only. */
    private static final int TRIES_BEFORE_FLOATS = 5;

    private static final int REFUSALS = 2;
    /** Over a slow link so many items are on their way at once, from vehicles that give them in any order. */
    private static final int MOST_AT_ONCE = 4;

    private static final double SLOW_MILLIS = 250;
    /** After so long every vehicle has given up an upload that broke off (PX4: 5 s, ArduPilot: 8 s). */
    private static final long GIVEN_UP_NANOS = 12_000_000_000L;

    private final MavlinkTarget target;
    private final MavMissionType kind;
    private final Part part;
    private final ExchangeObserver observer;
    private final TransferTimeout patience = new TransferTimeout();
    private final List<MissionItemInt> items = new ArrayList<>();
    private final PrefetchedItems ahead = new PrefetchedItems();
    private boolean inAnyOrder;
    private int count = -1;
    private int otherKind = -1;
    private int tries;
    private int refusals;
    private long firstRefusedNanos;
    private long lastSentNanos;
    private long stamp = MissionOpaqueId.NONE;
    private boolean integersReceived;
    private boolean floatsTaken;
    private @Nullable Outcome outcome;

    /** At most so many items from that one on. */
    private record Part(int first, int most) {}

    private MissionDownload(MavlinkTarget target, MavMissionType kind, Part part, ExchangeObserver observer) {
        this.target = target;
        this.kind = kind;
        this.part = part;
        this.observer = observer;
    }

    public static MissionDownload whole(MavlinkTarget target, MavMissionType kind) {
        return whole(target, kind, ExchangeObserver.NONE);
    }

    /** {@code observer} hears of every item. */
    public static MissionDownload whole(MavlinkTarget target, MavMissionType kind, ExchangeObserver observer) {
        return new MissionDownload(target, kind, new Part(0, MOST_ITEMS), observer);
    }

    /**
     * The vehicle gives each item that it is asked for, whichever it gave before (ArduPilot does; PX4 breaks off), so that a
     * slow link need not stand idle.
     */
    public MissionDownload inAnyOrder() {
        inAnyOrder = true;
        return this;
    }

    /** Only asks how many items there are. */
    public static MissionDownload count(MavlinkTarget target, MavMissionType kind) {
        return new MissionDownload(target, kind, new Part(0, 0), ExchangeObserver.NONE);
    }

    /** How many items there are, and some of them. */
    public static MissionDownload part(MavlinkTarget target, MavMissionType kind, int first, int most) {
        return new MissionDownload(target, kind, new Part(first, most), ExchangeObserver.NONE);
    }

    /** What was read so far, home included where the autopilot keeps it as item 0. */
    public List<MissionItemInt> items() {
        return items;
    }

    /** Positions are as exact as the vehicle knows them: none came as a floating-point number. */
    public boolean isExact() {
        return !floatsTaken;
    }

    /** The number that the vehicle gave this mission; {@link MissionOpaqueId#NONE} when it gave none. */
    public long stamp() {
        return stamp;
    }

    /** How many items the vehicle said it has; -1 before. */
    public int count() {
        return count;
    }

    @Override
    public void start(long nowNanos) {
        patience.begin(nowNanos);
        ask(nowNanos);
    }

    @Override
    public void received(Frame frame, long nowNanos) {
        if (outcome != null) {
            return;
        }
        patience.received(nowNanos);
        switch (frame.messageId()) {
            case MissionCount.ID -> counted(MissionCount.decode(frame), MissionOpaqueId.of(frame), nowNanos);
            case MissionItemInt.ID -> {
                integersReceived = true;
                itemReceived(MissionItemInt.decode(frame), nowNanos);
            }
            case MissionItem.ID ->
                floatsTaken |= itemReceived(LegacyMissionItems.exact(MissionItem.decode(frame)), nowNanos);
            case MissionAck.ID -> refused(MissionAck.decode(frame), nowNanos);
            default -> {}
        }
    }

    @Override
    public void advance(long nowNanos) {
        if (outcome != null || nowNanos - lastSentNanos < pauseNanos()) {
            return;
        }
        outcome = patience.end(nowNanos);
        if (outcome == null) {
            ask(nowNanos);
            askAhead(nowNanos);
        } else if (!patience.isBrokenOff(nowNanos)) {
            outcome = unanswered(outcome);
        }
    }

    /** The vehicle is heard and answers, but not what it was asked. */
    private Outcome unanswered(Outcome usual) {
        if (count < 0 && otherKind >= 0) {
            return new Outcome.TimedOut("Asked for its " + kind.words() + ", the vehicle answers with "
                    + MavMissionType.words(otherKind) + "; nothing was read.");
        }
        return count < 0
                ? usual
                : new Outcome.TimedOut("The vehicle says that it has " + count + " items and does not"
                        + " give number " + next()
                        + ", counted from 0, though it was asked for it again and again. So nothing of"
                        + " this was taken.");
    }

    /** As the link is now: a long transfer may begin on a good one and go on over a bad one. */
    private long pauseNanos() {
        return Math.max(
                LEAST_PAUSE_NANOS, RetrySchedule.of(target.roundTrip(), 0).pauseNanos(tries));
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
        } else if (!integersReceived && (floatsTaken ? tries % 2 == 0 : isTimeForFloats())) {
            // Old vehicles know only the request for an item with floating-point position, good to half a metre.
            target.send(new MissionRequest(system, component, next(), kind.number()));
        } else {
            target.send(new MissionRequestInt(system, component, next(), kind.number()));
        }
        patience.asked(nowNanos);
        tries++;
        lastSentNanos = nowNanos;
    }

    private boolean isTimeForFloats() {
        return tries >= TRIES_BEFORE_FLOATS && tries % 2 == 1;
    }

    private void askAhead(long nowNanos) {
        Double trip = target.roundTrip().smoothedMillis();
        if (!inAnyOrder || !integersReceived || count < 0 || trip == null || trip < SLOW_MILLIS) {
            return;
        }
        int end = Math.min(Math.min(count, part.first() + part.most()), next() + MOST_AT_ONCE);
        for (int seq = next() + 1; seq < end; seq++) {
            if (ahead.isWanted(seq, nowNanos, pauseNanos())) {
                target.send(new MissionRequestInt(target.systemId(), target.componentId(), seq, kind.number()));
                ahead.asked(seq, nowNanos);
            }
        }
    }

    private int next() {
        return part.first() + items.size();
    }

    private void counted(MissionCount message, long newStamp, long nowNanos) {
        if (count >= 0 || !MavlinkTarget.isForUs(message.targetSystem())) {
            return;
        }
        if (message.missionType() != kind.number()) {
            otherKind = message.missionType();
            return;
        }
        if (message.count() > MOST_ITEMS) {
            outcome = new Outcome.Failed("The vehicle says it has " + message.count() + " mission items.");
            return;
        }
        count = message.count();
        stamp = newStamp;
        goOn(nowNanos);
    }

    private boolean itemReceived(MissionItemInt item, long nowNanos) {
        if (count < 0 || item.missionType() != kind.number() || item.seq() < next()) {
            return false;
        }
        if (item.seq() > next()) {
            return ahead.keep(item);
        }
        for (MissionItemInt each = item; each != null; each = ahead.remove(next())) {
            items.add(each);
        }
        observer.progress(items.size(), count);
        goOn(nowNanos);
        return true;
    }

    private void goOn(long nowNanos) {
        patience.progressed(nowNanos);
        if (items.size() == part.most() || next() >= count) {
            target.send(new MissionAck(target.systemId(), target.componentId(), 0, kind.number()));
            outcome = new Outcome.Succeeded();
        } else {
            tries = 0;
            askNext(nowNanos);
            askAhead(nowNanos);
        }
    }

    private void askNext(long nowNanos) {
        Long asked = ahead.askedNanos(next());
        if (asked == null) {
            ask(nowNanos);
        } else {
            tries = 1;
            lastSentNanos = asked;
        }
    }

    /**
     * A refusal in the middle means that somebody else has changed the mission: begin again. The first one before that,
     * and a word about order, may still be about items of an upload that came twice. A vehicle that waits for the rest of
     * an upload that broke off gives nothing out until it has given that up.
     */
    private void refused(MissionAck ack, long nowNanos) {
        boolean ours = ack.missionType() == kind.number() && MavlinkTarget.isForUs(ack.targetSystem());
        if (ours && ack.type() != MavMissionResult.ACCEPTED && ack.type() != MavMissionResult.INVALID_SEQUENCE) {
            if (refusals++ == 0) {
                firstRefusedNanos = nowNanos;
            }
            boolean mayPass = MavMissionResult.isBusy(ack.type()) && nowNanos - firstRefusedNanos < GIVEN_UP_NANOS;
            if (mayPass) {
                patience.answered();
            }
            if (count < 0 && refusals >= REFUSALS && !mayPass) {
                outcome = new Outcome.Refused("vehicle", MavMissionResult.refusal(ack.type()));
            } else if (count >= 0) {
                count = -1;
                refusals = 0;
                items.clear();
                ahead.forget();
                floatsTaken = false;
            }
        }
    }
}
