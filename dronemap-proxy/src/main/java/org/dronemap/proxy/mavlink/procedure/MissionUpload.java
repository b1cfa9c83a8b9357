package org.dronemap.proxy.mavlink.procedure;

import java.util.List;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.Severity;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionRequest;
import org.dronemap.mavlink.message.MissionRequestInt;
import org.jspecify.annotations.Nullable;

/**
 * Writes a mission (or fence, or rally points) to a vehicle, which asks for the items one by one. Items given are the wire's, numbered from 0. A
 * transfer that stalls is begun again; when only the last acknowledgement is missing, a read-back must tell.
 */
public final class MissionUpload implements Exchange {
    private static final int ROUNDS = 3;
    private static final int TRIES_FOR_THE_LAST_WORD = 3;
    /** A vehicle that does not react to one item so often has given the transfer up on its side. */
    private static final int TRIES_BEFORE_BEGINNING_AGAIN = 5;

    private static final long LEAST_PAUSE_NANOS = 500_000_000L;
    private static final long REASON_NANOS = 700_000_000L;

    private final Target target;
    private final MissionKind kind;
    private final List<MissionItemInt> items;
    private final Observer observer;
    private final Patience patience = new Patience();
    private Pace pace = new Pace(0, 0, 0);
    private int asked = -1;
    private int highest = -1;
    private int tries;
    private int rounds = 1;
    private long lastSentNanos;
    private int refusal;
    private long refusedNanos;
    private @Nullable String reason;
    private @Nullable Outcome outcome;

    public MissionUpload(Target target, MissionKind kind, List<MissionItemInt> items, Observer observer) {
        this.target = target;
        this.kind = kind;
        this.items = List.copyOf(items);
        this.observer = observer;
    }

    @Override
    public void start(long nowNanos) {
        pace = Pace.of(target.roundTrip(), 0);
        patience.begin(nowNanos);
        send(nowNanos);
    }

    @Override
    public void heard(Frame frame, long nowNanos) {
        if (outcome != null || refusal != 0) {
            return;
        }
        patience.heard(nowNanos);
        switch (frame.messageId()) {
            case MissionRequestInt.ID -> {
                MissionRequestInt request = MissionRequestInt.decode(frame);
                requested(request.seq(), request.missionType(), request.targetSystem(), nowNanos);
            }
            case MissionRequest.ID -> {
                MissionRequest request = MissionRequest.decode(frame);
                requested(request.seq(), request.missionType(), request.targetSystem(), nowNanos);
            }
            case MissionAck.ID -> acknowledged(MissionAck.decode(frame), nowNanos);
            default -> {}
        }
    }

    @Override
    public void said(Severity severity, String text, long nowNanos) {
        if (severity.compareTo(Severity.WARNING) <= 0) {
            reason = text;
        }
    }

    @Override
    public void tick(long nowNanos) {
        if (outcome != null) {
            return;
        }
        if (refusal != 0) {
            if (reason != null || nowNanos - refusedNanos >= REASON_NANOS) {
                outcome = new Outcome.Refused("vehicle", reason != null ? reason : MissionResult.words(refusal));
            }
        } else if (nowNanos - lastSentNanos >= Math.max(LEAST_PAUSE_NANOS, pace.pauseNanos(tries))) {
            again(nowNanos);
        }
    }

    @Override
    public @Nullable Outcome outcome() {
        return outcome;
    }

    private void again(long nowNanos) {
        if (allAsked() && tries >= TRIES_FOR_THE_LAST_WORD && patience.isAudible(nowNanos)) {
            outcome = new Outcome.Succeeded();
            return;
        }
        outcome = patience.end(nowNanos);
        if (outcome != null) {
            return;
        }
        if (tries >= TRIES_BEFORE_BEGINNING_AGAIN) {
            asked = -1;
            tries = 0;
        }
        send(nowNanos);
    }

    private boolean allAsked() {
        return asked == items.size() - 1;
    }

    private void send(long nowNanos) {
        if (asked < 0) {
            target.send(new MissionCount(target.systemId(), target.componentId(), items.size(), kind.number()));
        } else {
            target.send(items.get(asked));
        }
        patience.asked(nowNanos);
        tries++;
        lastSentNanos = nowNanos;
    }

    private void requested(int seq, int missionType, int targetSystem, long nowNanos) {
        if (missionType != kind.number() || seq >= items.size() || !Target.isForUs(targetSystem)) {
            return;
        }
        if (seq != asked) {
            tries = 0;
            patience.news(nowNanos);
        }
        asked = seq;
        if (seq > highest) {
            highest = seq;
            observer.progress(seq, items.size());
        }
        send(nowNanos);
    }

    private void acknowledged(MissionAck ack, long nowNanos) {
        if (ack.missionType() != kind.number() || !Target.isForUs(ack.targetSystem())) {
            return;
        }
        if (ack.type() == MissionResult.ACCEPTED) {
            if (allAsked()) {
                observer.progress(items.size(), items.size());
                outcome = new Outcome.Succeeded();
            }
        } else if (allAsked() && tries > 1) {
            // The last word was lost and the vehicle wonders about the repetition: reading back must tell.
            outcome = new Outcome.Succeeded();
        } else if (ack.type() == MissionResult.INVALID_SEQUENCE) {
            // An item came twice or late, maybe of an earlier round; the vehicle asks for the one that it wants.
            lastSentNanos = nowNanos;
        } else if (MissionResult.isPassing(ack.type()) && rounds < ROUNDS) {
            // The tick begins again after a pause, so that two sides never chase each other.
            asked = -1;
            tries = 0;
            rounds++;
            lastSentNanos = nowNanos;
        } else {
            refusal = ack.type();
            refusedNanos = nowNanos;
        }
    }
}
