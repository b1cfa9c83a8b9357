package org.dronemap.proxy.mavlink.procedure;

import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.Severity;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandCancel;
import org.jspecify.annotations.Nullable;

/** Sends one MAV_CMD to a vehicle, repeated as its retry class allows, until acknowledged or seen to be done. */
public final class CommandExchange implements Exchange {
    private static final long DEADLINE_NANOS = 8_000_000_000L;
    private static final long VERIFIED_DEADLINE_NANOS = 15_000_000_000L;
    private static final long IN_PROGRESS_NANOS = 30_000_000_000L;
    private static final long ASK_PROGRESS_NANOS = 5_000_000_000L;
    /** A refused repetition may follow a first try that acted: so long its effect may take to show. */
    private static final long EFFECT_NANOS = 3_000_000_000L;
    /** Who said nothing for so long after accepting cannot be called failed. */
    private static final long SILENCE_NANOS = 2_000_000_000L;
    /** What was said sooner after the acceptance may have been written before it. */
    private static final long SAID_AFTER_NANOS = 1_000_000_000L;
    /** Real vehicles leave out heartbeats for six seconds while all else flows. */
    private static final long LONGEST_UNSAID_NANOS = 12_000_000_000L;

    private final MavlinkTarget target;
    private final MavCommandRequest request;
    private final ExchangeObserver observer;
    private final RefusalTextFinder reasons;
    private RetrySchedule pace = new RetrySchedule(0, 0, 0);
    private boolean seenAtStart;
    private int tries;
    private long settledNanos;
    private long lastSentNanos;
    private long lastReceivedNanos;
    private long deadlineNanos;
    private boolean accepted;
    private long acceptedNanos;
    private boolean reportedSince;
    private boolean inProgress;
    private long lastProgressNanos;
    private int refusal;
    private long refusedNanos;
    private @Nullable Outcome outcome;

    public CommandExchange(MavlinkTarget target, MavCommandRequest request, ExchangeObserver observer) {
        this.target = target;
        this.request = request;
        this.observer = observer;
        this.reasons = new RefusalTextFinder(request.command());
    }

    @Override
    public void start(long nowNanos) {
        seenAtStart = request.proof().seen().getAsBoolean();
        pace = switch (request.retry()) {
            case REPEATABLE -> RetrySchedule.of(target.roundTrip(), DEADLINE_NANOS);
            case VERIFY_FIRST -> RetrySchedule.of(target.roundTrip(), VERIFIED_DEADLINE_NANOS);
            case ONCE -> RetrySchedule.single(target.roundTrip(), DEADLINE_NANOS);
        };
        settledNanos = target.ledger().settledNanos(request.command(), nowNanos, target.roundTrip());
        deadlineNanos = settledNanos + pace.deadlineNanos();
        lastReceivedNanos = nowNanos;
        if (request.retry() != MavCommandRequest.Retry.ONCE || settledNanos - nowNanos <= 0) {
            send(nowNanos);
        }
    }

    @Override
    public void received(Frame frame, long nowNanos) {
        if (outcome != null) {
            return;
        }
        lastReceivedNanos = nowNanos;
        if (accepted && isProof(frame) && nowNanos - acceptedNanos >= SAID_AFTER_NANOS) {
            reportedSince = true;
        }
        if (frame.messageId() == CommandAck.ID) {
            CommandAck ack = CommandAck.decode(frame);
            if (ack.command() == request.command() && MavlinkTarget.isForUs(ack.targetSystem())) {
                commandAckReceived(ack, nowNanos);
            }
        }
        look();
    }

    private boolean isProof(Frame frame) {
        int telling = request.proof().shownBy();
        return telling == MavCommandRequest.CompletionCheck.ANY || frame.messageId() == telling;
    }

    /** What comes before an earlier exchange of this command has settled may belong to that one. */
    private void commandAckReceived(CommandAck ack, long nowNanos) {
        target.ledger().crossed(ack.command(), nowNanos);
        if (tries > 0 && nowNanos - settledNanos >= 0) {
            if (tries == 1 && !inProgress && !accepted) {
                target.roundTrip().measured(nowNanos - lastSentNanos);
            }
            acknowledged(ack, nowNanos);
        }
    }

    @Override
    public void textReceived(Severity severity, String text, long nowNanos) {
        reasons.textReceived(severity, text, nowNanos);
    }

    @Override
    public void advance(long nowNanos) {
        look();
        if (outcome != null) {
            return;
        }
        if (refusal != 0) {
            concludeRefusal(nowNanos);
        } else if (accepted) {
            concludeAccepted(nowNanos);
        } else if (nowNanos - deadlineNanos >= 0) {
            outcome = unanswered();
        } else if (maySend(nowNanos)) {
            send(nowNanos);
        }
    }

    @Override
    public void cancel(long nowNanos) {
        if (outcome == null && inProgress && !accepted) {
            target.send(new CommandCancel(target.systemId(), target.componentId(), request.command()));
        }
    }

    private Outcome unanswered() {
        if (inProgress) {
            return new Outcome.Unknown("The vehicle began, but never said that it finished.");
        }
        if (request.retry() == MavCommandRequest.Retry.ONCE) {
            return new Outcome.Unknown("It was sent once and not acknowledged within " + pace.deadline()
                    + "; the vehicle may have carried it out or not.");
        }
        return noAnswer(pace.deadline(), tries);
    }

    static Outcome noAnswer(long withinNanos, int tries) {
        return noAnswer(withinNanos / 1_000_000_000L + " s", tries);
    }

    private static Outcome noAnswer(String within, int tries) {
        return new Outcome.TimedOut("No answer from the vehicle within " + within + " (" + tries + " tries).");
    }

    @Override
    public @Nullable Outcome outcome() {
        return outcome;
    }

    private boolean maySend(long nowNanos) {
        if (tries == 0) {
            return nowNanos - settledNanos >= 0;
        }
        long pause = pace.pauseNanos(tries);
        if (nowNanos - lastSentNanos < pause || deadlineNanos - nowNanos < pace.firstNanos()) {
            return false;
        }
        return switch (request.retry()) {
            case ONCE -> false;
            // What was said later than an answer takes shows the vehicle as the last try left it.
            case VERIFY_FIRST -> !inProgress && lastReceivedNanos - lastSentNanos >= pace.firstNanos();
            case REPEATABLE ->
                !inProgress || nowNanos - Math.max(lastProgressNanos, lastSentNanos) >= ASK_PROGRESS_NANOS;
        };
    }

    private void send(long nowNanos) {
        target.send(request.message().apply(tries));
        target.ledger().crossed(request.command(), nowNanos);
        if (tries == 0) {
            deadlineNanos = nowNanos + pace.deadlineNanos();
        } else if (tries == 1) {
            target.roundTrip().repeated();
        }
        tries++;
        lastSentNanos = nowNanos;
    }

    private void acknowledged(CommandAck ack, long nowNanos) {
        if (ack.result() == MavResult.ACCEPTED) {
            refusal = 0;
            if (!accepted) {
                accepted = true;
                acceptedNanos = nowNanos;
                observer.accepted();
            }
        } else if (ack.result() == MavResult.IN_PROGRESS) {
            progressed(ack, nowNanos);
        } else if (refusal == 0 && !accepted) {
            refusal = ack.result();
            refusedNanos = nowNanos;
        }
    }

    private void progressed(CommandAck ack, long nowNanos) {
        if (!inProgress) {
            inProgress = true;
            observer.accepted();
        }
        if (ack.progress() > 0 && ack.progress() <= 100) {
            observer.progress(ack.progress(), 100);
        }
        lastProgressNanos = nowNanos;
        deadlineNanos = nowNanos + IN_PROGRESS_NANOS;
    }

    /** Done is done, whether or not the acknowledgement came; but what was so before proves nothing. */
    private void look() {
        boolean refusedAtOnce = refusal != 0 && tries == 1;
        if (outcome != null
                || tries == 0
                || refusedAtOnce
                || !request.proof().seen().getAsBoolean()) {
            return;
        }
        if (accepted || (!seenAtStart && lastReceivedNanos - lastSentNanos >= 0)) {
            outcome = new Outcome.Succeeded();
        }
    }

    private void concludeAccepted(long nowNanos) {
        long since = nowNanos - acceptedNanos;
        if (since <= request.proof().patience().toNanos()) {
            return;
        }
        if (nowNanos - lastReceivedNanos >= SILENCE_NANOS) {
            outcome =
                    new Outcome.Unknown("The vehicle accepted it and then fell silent, before it was seen to be done.");
        } else if (reportedSince) {
            outcome = new Outcome.Failed(request.proof().unseen());
        } else if (since > LONGEST_UNSAID_NANOS) {
            outcome = new Outcome.Unknown("The vehicle accepted it, but has not said what it does since.");
        }
    }

    private void concludeRefusal(long nowNanos) {
        boolean mayShowStill = tries > 1 && !seenAtStart;
        if (mayShowStill && nowNanos - refusedNanos < EFFECT_NANOS) {
            return;
        }
        String reason = reasons.of(refusedNanos, MavResult.words(refusal), nowNanos);
        if (reason != null) {
            outcome = new Outcome.Refused("vehicle", MavResult.refusal(refusal, reason));
        }
    }

    /** True after a refusal that only says that the vehicle does not know this command, or not in this form. */
    public boolean isUnknownToVehicle() {
        return MavResult.isUnknown(refusal);
    }
}
