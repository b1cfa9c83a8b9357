package org.dronemap.proxy.mavlink.procedure;

import java.util.function.Supplier;
import org.dronemap.core.command.Outcome;
import org.dronemap.mavlink.Frame;
import org.jspecify.annotations.Nullable;

/** An exchange that sends nothing to the vehicle: its outcome is known when it begins. */
public final class ImmediateExchange implements Exchange {
    private final Supplier<Outcome> verdict;
    private @Nullable Outcome outcome;

    public ImmediateExchange(Supplier<Outcome> verdict) {
        this.verdict = verdict;
    }

    @Override
    public void start(long nowNanos) {
        outcome = verdict.get();
    }

    @Override
    public void received(Frame frame, long nowNanos) {}

    @Override
    public void advance(long nowNanos) {}

    @Override
    public @Nullable Outcome outcome() {
        return outcome;
    }
}
