package org.dronemap.proxy.mavlink.procedure;

import java.util.concurrent.CompletableFuture;
import org.dronemap.core.command.Outcome;
import org.dronemap.mavlink.Frame;
import org.jspecify.annotations.Nullable;

/** An exchange that sends nothing to the vehicle, but waits for work of the cloud, such as a write to the store. */
public final class FutureExchange implements Exchange {
    private static final long LONGEST_NANOS = 3_000_000_000L;

    private final CompletableFuture<Void> awaited;
    private final String otherwise;
    private long startedNanos;
    private @Nullable Outcome outcome;

    /** {@code otherwise}: a sentence for when it fails, or takes too long. */
    public FutureExchange(CompletableFuture<Void> awaited, String otherwise) {
        this.awaited = awaited;
        this.otherwise = otherwise;
    }

    @Override
    public void start(long nowNanos) {
        startedNanos = nowNanos;
        advance(nowNanos);
    }

    @Override
    public void received(Frame frame, long nowNanos) {}

    @Override
    public void advance(long nowNanos) {
        if (outcome != null) {
            return;
        }
        if (awaited.isDone() && !awaited.isCompletedExceptionally()) {
            outcome = new Outcome.Succeeded();
        } else if (awaited.isDone() || nowNanos - startedNanos > LONGEST_NANOS) {
            outcome = new Outcome.Failed(otherwise);
        }
    }

    @Override
    public @Nullable Outcome outcome() {
        return outcome;
    }
}
