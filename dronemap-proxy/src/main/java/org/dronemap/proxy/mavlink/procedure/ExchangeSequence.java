package org.dronemap.proxy.mavlink.procedure;

import java.util.ArrayDeque;
import java.util.List;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.Severity;
import org.dronemap.mavlink.Frame;
import org.jspecify.annotations.Nullable;

/** Runs several exchanges with a vehicle one after the other, and ends at the first that fails. */
public final class ExchangeSequence implements Exchange {
    private final ArrayDeque<Step> steps;
    private @Nullable Step step;
    private @Nullable Exchange current;
    private @Nullable Outcome outcome;

    /**
     * One step. {@code begin} is asked when its turn comes; {@code goesOn}: whether the next step follows on that
     * outcome.
     */
    public record Step(Supplier<Exchange> begin, Predicate<Outcome> goesOn) {
        /** Must succeed. */
        public static Step of(Supplier<Exchange> begin) {
            return new Step(begin, Outcome.Succeeded.class::isInstance);
        }

        /** Left out when {@code needed} says no. */
        public static Step when(java.util.function.BooleanSupplier needed, Supplier<Exchange> begin) {
            return of(() -> needed.getAsBoolean() ? begin.get() : new ImmediateExchange(Outcome.Succeeded::new));
        }
    }

    public ExchangeSequence(List<Step> steps) {
        this.steps = new ArrayDeque<>(steps);
    }

    @Override
    public void start(long nowNanos) {
        startNext(nowNanos);
    }

    @Override
    public void received(Frame frame, long nowNanos) {
        if (current != null) {
            current.received(frame, nowNanos);
            startNext(nowNanos);
        }
    }

    @Override
    public void textReceived(Severity severity, String text, long nowNanos) {
        if (current != null) {
            current.textReceived(severity, text, nowNanos);
        }
    }

    @Override
    public void advance(long nowNanos) {
        if (current != null) {
            current.advance(nowNanos);
            startNext(nowNanos);
        }
    }

    @Override
    public void cancel(long nowNanos) {
        if (current != null) {
            current.cancel(nowNanos);
        }
    }

    @Override
    public @Nullable Outcome outcome() {
        return outcome;
    }

    private void startNext(long nowNanos) {
        while (outcome == null) {
            Outcome ended = current == null ? new Outcome.Succeeded() : current.outcome();
            if (ended == null) {
                return;
            }
            boolean goesOn = step == null || step.goesOn().test(ended);
            Step next = steps.poll();
            if (!goesOn || next == null) {
                outcome = goesOn ? new Outcome.Succeeded() : ended;
                current = null;
                return;
            }
            step = next;
            current = next.begin().get();
            current.start(nowNanos);
        }
    }
}
