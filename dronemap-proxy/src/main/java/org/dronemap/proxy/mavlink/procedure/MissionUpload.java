package org.dronemap.proxy.mavlink.procedure;

import java.util.List;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.Severity;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionRequest;
import org.dronemap.mavlink.message.MissionRequestInt;
import org.dronemap.mavlink.message.MissionWritePartialList;
import org.jspecify.annotations.Nullable;

/**
 * Uploads a mission, fence or rally points, whole or in part, to a vehicle, which requests the items one by one. Items
 * given are the wire's, numbered from 0. Who asks in the old form and takes no integer items gets floating-point ones,
 * which are less exact. A transfer that stalls is begun again; when only the last acknowledgement is
 * missing, a read-back must tell.
 */
public final class MissionUpload implements Exchange {
    private static final int ROUNDS = 3;
    private static final int TRIES_FOR_THE_LAST_WORD = 3;
    /** A vehicle that does not react to one item so often has given the transfer up on its side. */
    private static final int TRIES_BEFORE_BEGINNING_AGAIN = 5;

    private static final long LEAST_PAUSE_NANOS = 500_000_000L;
    private static final long REASON_NANOS = 700_000_000L;

    private final MavlinkTarget target;
    private final MavMissionType kind;
    private final List<MissionItemInt> items;
    private final Span span;
    private final ExchangeObserver observer;
    private final TransferTimeout patience = new TransferTimeout();
    private int asked = -1;
    private int highest = -1;
    /** The vehicle has asked for the last item, so that all before it have arrived. */
    private boolean lastAsked;

    private final MissionItemForm form = new MissionItemForm();
    private int tries;
    /** How often the last item went out and the vehicle was heard after that. */
    private int lastWords;

    private boolean lastWordOpen;

    private int begunAgain;
    private int rounds = 1;
    private long lastSentNanos;
    private int refusal;
    private long refusedNanos;
    private @Nullable String reason;
    private @Nullable Outcome outcome;

    /** The items from the first to the last; both count. */
    public record Span(int first, int last) {
        public int size() {
            return last - first + 1;
        }
    }

    private MissionUpload(
            MavlinkTarget target,
            MavMissionType kind,
            List<MissionItemInt> items,
            Span span,
            ExchangeObserver observer) {
        this.target = target;
        this.kind = kind;
        this.items = List.copyOf(items);
        this.span = span;
        this.observer = observer;
    }

    /** All of it. */
    public MissionUpload(
            MavlinkTarget target, MavMissionType kind, List<MissionItemInt> items, ExchangeObserver observer) {
        this(target, kind, items, new Span(0, items.size() - 1), observer);
    }

    /** Only what lies within the span goes up; the vehicle keeps what it holds before and behind it. */
    public static MissionUpload part(
            MavlinkTarget target,
            MavMissionType kind,
            List<MissionItemInt> items,
            Span span,
            ExchangeObserver observer) {
        return new MissionUpload(target, kind, items, span, observer);
    }

    /** {@code known}: the vehicle says of itself that it takes integer items; it is given nothing else. */
    public MissionUpload withIntegerItems(boolean known) {
        if (known) {
            form.knowsIntegers();
        }
        return this;
    }

    @Override
    public void start(long nowNanos) {
        patience.begin(nowNanos);
        send(nowNanos);
    }

    @Override
    public void received(Frame frame, long nowNanos) {
        if (outcome != null || refusal != 0) {
            return;
        }
        patience.received(nowNanos);
        if (lastWordOpen) {
            lastWordOpen = false;
            lastWords++;
        }
        switch (frame.messageId()) {
            case MissionRequestInt.ID -> {
                MissionRequestInt request = MissionRequestInt.decode(frame);
                form.asked(false);
                requested(request.seq(), request.missionType(), request.targetSystem(), nowNanos);
            }
            case MissionRequest.ID -> {
                MissionRequest request = MissionRequest.decode(frame);
                form.asked(true);
                requested(request.seq(), request.missionType(), request.targetSystem(), nowNanos);
            }
            case MissionAck.ID -> acknowledged(MissionAck.decode(frame), nowNanos);
            default -> {}
        }
    }

    @Override
    public void textReceived(Severity severity, String text, long nowNanos) {
        if (severity.compareTo(Severity.WARNING) <= 0) {
            reason = text;
        }
    }

    @Override
    public void advance(long nowNanos) {
        if (outcome != null) {
            return;
        }
        if (refusal != 0) {
            if (reason != null || nowNanos - refusedNanos >= REASON_NANOS) {
                outcome = new Outcome.Refused(
                        "vehicle",
                        MavMissionResult.refusal(refusal, reason != null ? reason : MavMissionResult.words(refusal)));
            }
        } else if (nowNanos - lastSentNanos >= pauseNanos()) {
            again(nowNanos);
        }
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

    private void again(long nowNanos) {
        boolean silentAtTheEnd = lastAsked && lastWords >= TRIES_FOR_THE_LAST_WORD && !form.isUntried();
        if (silentAtTheEnd && patience.isAudible(nowNanos)) {
            outcome = new Outcome.Succeeded();
            return;
        }
        outcome = acceptsNoForm(nowNanos) ? new Outcome.Failed(noForm()) : patience.end(nowNanos);
        if (outcome != null) {
            return;
        }
        if (tries >= TRIES_BEFORE_BEGINNING_AGAIN) {
            begunAgain++;
            beginAgain();
        }
        send(nowNanos);
    }

    /** It asks for items and takes the first one in no form, however often both went out. */
    private boolean acceptsNoForm(long nowNanos) {
        return form.isOpen() && begunAgain >= ROUNDS && patience.isAudible(nowNanos);
    }

    private static String noForm() {
        return "The vehicle asks for the first item again and again, and takes it neither as MISSION_ITEM_INT nor as"
                + " MISSION_ITEM; so it got nothing of this.";
    }

    private void beginAgain() {
        asked = -1;
        lastAsked = false;
        lastWords = 0;
        tries = 0;
    }

    private void send(long nowNanos) {
        if (asked < 0) {
            target.send(announcement());
        } else {
            target.send(form.of(items.get(asked), tries));
        }
        patience.asked(nowNanos);
        tries++;
        lastWordOpen = lastAsked;
        lastSentNanos = nowNanos;
    }

    /** Whether the vehicle has asked for an item, and may have changed something. */
    public boolean isBegun() {
        return highest >= 0;
    }

    /** Whether the vehicle took items in floating point. */
    public boolean isRounded() {
        return form.isRounded();
    }

    /** The items as the vehicle was able to take them. */
    public List<MissionItemInt> acceptedItems() {
        return form.isRounded()
                ? items.stream()
                        .map(item -> LegacyMissionItems.exact(LegacyMissionItems.older(item)))
                        .toList()
                : items;
    }

    private Message announcement() {
        int system = target.systemId();
        int component = target.componentId();
        return span.size() < items.size()
                ? new MissionWritePartialList(system, component, span.first(), span.last(), kind.number())
                : new MissionCount(system, component, items.size(), kind.number());
    }

    private void requested(int seq, int missionType, int targetSystem, long nowNanos) {
        boolean offered = seq >= span.first() && seq <= span.last();
        if (missionType != kind.number() || !offered || !MavlinkTarget.isForUs(targetSystem)) {
            return;
        }
        patience.answered();
        if (seq < asked && seq != span.first()) {
            // Vehicles ask in order: this question was overtaken by a later one, which counts.
            return;
        }
        if (asked >= 0 && seq == asked + 1) {
            form.accepted();
        }
        if (seq != asked) {
            tries = 0;
            patience.progressed(nowNanos);
        }
        asked = seq;
        lastAsked = seq == span.last();
        lastWords = 0;
        if (seq > highest) {
            highest = seq;
            observer.progress(seq - span.first(), span.size());
        }
        send(nowNanos);
    }

    private void acknowledged(MissionAck ack, long nowNanos) {
        if (ack.missionType() != kind.number() || !MavlinkTarget.isForUs(ack.targetSystem())) {
            return;
        }
        if (ack.type() == MavMissionResult.ACCEPTED) {
            if (lastAsked) {
                form.accepted();
                observer.progress(span.size(), span.size());
                outcome = new Outcome.Succeeded();
            }
        } else if (lastAsked && tries > 1) {
            // The last word was lost and the vehicle wonders about the repetition: reading back must tell.
            outcome = new Outcome.Succeeded();
        } else if (ack.type() == MavMissionResult.INVALID_SEQUENCE) {
            // An item came twice or late, maybe of an earlier round; the vehicle asks for the one that it wants.
            lastSentNanos = nowNanos;
        } else if (MavMissionResult.isPassing(ack.type()) && rounds < ROUNDS) {
            // The tick begins again after a pause, so that two sides never chase each other.
            beginAgain();
            rounds++;
            lastSentNanos = nowNanos;
        } else {
            refusal = ack.type();
            refusedNanos = nowNanos;
        }
    }
}
