package org.dronemap.proxy.mavlink.procedure;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.Severity;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.CommandAck;
import org.jspecify.annotations.Nullable;

/**
 * Carries one MAV_CMD out: sent up to nine times with rising confirmation until it is acknowledged or seen to be done;
 * a refusal waits for the sentence that the vehicle says about it.
 */
public final class CommandExchange implements Exchange {
    private static final int TRIES = 9;
    private static final long BETWEEN_TRIES_NANOS = 800_000_000L;
    private static final long DEADLINE_NANOS = 8_000_000_000L;
    private static final long IN_PROGRESS_NANOS = 30_000_000_000L;
    private static final long REASON_BEFORE_NANOS = 500_000_000L;
    private static final long REASON_AFTER_NANOS = 1_000_000_000L;
    private static final long MORE_REASONS_NANOS = 250_000_000L;
    private static final int MAX_SENTENCES = 4;

    /** A sentence of the vehicle that may be why it refused. */
    private record Sentence(Severity severity, String text, long atNanos) {}

    private final Target target;
    private final CommandRequest request;
    private final Observer observer;
    private final List<Sentence> sentences = new ArrayList<>();
    private boolean seenAtStart;
    private int tries;
    private long lastSentNanos;
    private long lastHeardNanos;
    private long deadlineNanos;
    private boolean accepted;
    private long acceptedNanos;
    private boolean inProgress;
    private int refusal;
    private long refusedNanos;
    private @Nullable Outcome outcome;

    public CommandExchange(Target target, CommandRequest request, Observer observer) {
        this.target = target;
        this.request = request;
        this.observer = observer;
    }

    @Override
    public void start(long nowNanos) {
        seenAtStart = request.proof().seen().getAsBoolean();
        deadlineNanos = nowNanos + DEADLINE_NANOS;
        lastHeardNanos = nowNanos;
        send(nowNanos);
    }

    @Override
    public void heard(Frame frame, long nowNanos) {
        if (outcome != null) {
            return;
        }
        lastHeardNanos = nowNanos;
        if (frame.messageId() == CommandAck.ID) {
            CommandAck ack = CommandAck.decode(frame);
            if (ack.command() == request.command() && Target.isForUs(ack.targetSystem())) {
                acknowledged(ack, nowNanos);
            }
        }
        look();
    }

    @Override
    public void said(Severity severity, String text, long nowNanos) {
        if (sentences.size() == MAX_SENTENCES) {
            sentences.remove(0);
        }
        sentences.add(new Sentence(severity, text, nowNanos));
    }

    @Override
    public void tick(long nowNanos) {
        look();
        if (outcome != null) {
            return;
        }
        if (refusal != 0) {
            concludeRefusal(nowNanos);
        } else if (accepted) {
            if (nowNanos - acceptedNanos > request.proof().patience().toNanos()) {
                outcome = new Outcome.Failed(request.proof().unseen());
            }
        } else if (nowNanos - deadlineNanos >= 0) {
            outcome = inProgress
                    ? new Outcome.Unknown("The vehicle began, but never said that it finished.")
                    : noAnswer(DEADLINE_NANOS, tries);
        } else if (mayResend(nowNanos)) {
            send(nowNanos);
        }
    }

    static Outcome noAnswer(long withinNanos, int tries) {
        return new Outcome.TimedOut(
                "No answer from the vehicle within " + withinNanos / 1_000_000_000L + " s (" + tries + " tries).");
    }

    @Override
    public @Nullable Outcome outcome() {
        return outcome;
    }

    private boolean mayResend(long nowNanos) {
        return !inProgress
                && tries < TRIES
                && nowNanos - lastSentNanos >= BETWEEN_TRIES_NANOS
                && (request.retry() == CommandRequest.Retry.REPEATABLE || lastHeardNanos - lastSentNanos > 0);
    }

    private void send(long nowNanos) {
        target.send(request.message().apply(tries));
        tries++;
        lastSentNanos = nowNanos;
    }

    private void acknowledged(CommandAck ack, long nowNanos) {
        if (ack.result() == MavResult.ACCEPTED) {
            if (!accepted) {
                accepted = true;
                acceptedNanos = nowNanos;
                observer.accepted();
            }
        } else if (ack.result() == MavResult.IN_PROGRESS) {
            if (!inProgress) {
                inProgress = true;
                observer.accepted();
            }
            deadlineNanos = nowNanos + IN_PROGRESS_NANOS;
        } else if (refusal == 0 && !accepted) {
            refusal = ack.result();
            refusedNanos = nowNanos;
        }
    }

    /** Done is done, whether or not the acknowledgement came; but what was so before proves nothing. */
    private void look() {
        if (outcome != null || refusal != 0 || !request.proof().seen().getAsBoolean()) {
            return;
        }
        if (accepted || (!seenAtStart && lastHeardNanos - lastSentNanos >= 0)) {
            outcome = new Outcome.Succeeded();
        }
    }

    private void concludeRefusal(long nowNanos) {
        Set<String> grave = new LinkedHashSet<>();
        Set<String> any = new LinkedHashSet<>();
        long newest = refusedNanos - REASON_BEFORE_NANOS;
        for (Sentence sentence : sentences) {
            if (sentence.atNanos() >= refusedNanos - REASON_BEFORE_NANOS) {
                any.add(sentence.text());
                newest = Math.max(newest, sentence.atNanos());
                if (sentence.severity().compareTo(Severity.WARNING) <= 0) {
                    grave.add(sentence.text());
                }
            }
        }
        boolean enough = !grave.isEmpty() && nowNanos - Math.max(newest, refusedNanos) >= MORE_REASONS_NANOS;
        if (enough || nowNanos - refusedNanos >= REASON_AFTER_NANOS) {
            Set<String> reasons = grave.isEmpty() ? any : grave;
            String reason = reasons.isEmpty() ? MavResult.words(refusal) : String.join("; ", reasons);
            outcome = new Outcome.Refused("vehicle", reason);
        }
    }

    /** True after a refusal that only says that the vehicle does not know this command, or not in this form. */
    public boolean isUnknownToVehicle() {
        return MavResult.isUnknown(refusal);
    }
}
