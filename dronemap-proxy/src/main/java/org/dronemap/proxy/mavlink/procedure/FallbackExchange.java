package org.dronemap.proxy.mavlink.procedure;

import java.util.function.Predicate;
import java.util.function.Supplier;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.Severity;
import org.dronemap.mavlink.Frame;
import org.jspecify.annotations.Nullable;

/** Runs a second exchange with a vehicle when the first one ends with a certain outcome. */
public final class FallbackExchange implements Exchange {
    private final Predicate<Outcome> tryOther;
    private @Nullable Supplier<Exchange> other;
    private Exchange current;

    public FallbackExchange(Exchange first, Predicate<Outcome> tryOther, Supplier<Exchange> other) {
        this.current = first;
        this.tryOther = tryOther;
        this.other = other;
    }

    @Override
    public void start(long nowNanos) {
        current.start(nowNanos);
        change(nowNanos);
    }

    @Override
    public void received(Frame frame, long nowNanos) {
        current.received(frame, nowNanos);
        change(nowNanos);
    }

    @Override
    public void textReceived(Severity severity, String text, long nowNanos) {
        current.textReceived(severity, text, nowNanos);
    }

    @Override
    public void advance(long nowNanos) {
        current.advance(nowNanos);
        change(nowNanos);
    }

    @Override
    public void cancel(long nowNanos) {
        current.cancel(nowNanos);
    }

    @Override
    public @Nullable Outcome outcome() {
        return current.outcome();
    }

    private void change(long nowNanos) {
        Outcome ended = current.outcome();
        Supplier<Exchange> next = other;
        if (ended != null && next != null && tryOther.test(ended)) {
            other = null;
            current = next.get();
            current.start(nowNanos);
        }
    }
}
