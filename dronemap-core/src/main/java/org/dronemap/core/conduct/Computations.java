package org.dronemap.core.conduct;

import java.time.Clock;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.dronemap.core.operation.Computation;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Where operations have things worked out: a few threads, and a queue that refuses when it is full. Any thread. */
final class Computations implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(Computations.class);

    private final LongSupplier nanoTime;
    private final Clock clock;
    private final ThreadPoolExecutor pool;

    Computations(int threads, int queued, LongSupplier nanoTime, Clock clock) {
        this.nanoTime = nanoTime;
        this.clock = clock;
        AtomicInteger numbers = new AtomicInteger();
        pool = new ThreadPoolExecutor(threads, threads, 0, TimeUnit.SECONDS, new ArrayBlockingQueue<>(queued), work -> {
            Thread thread = new Thread(work, "computation-" + numbers.incrementAndGet());
            thread.setDaemon(true);
            return thread;
        });
    }

    /** Something that is worked out, until it is called off: then nobody hears of its result. */
    static final class Underway {
        private volatile boolean calledOff;

        void callOff() {
            calledOff = true;
        }
    }

    /** {@code then} hears of the result once, on any thread, this one too. */
    <I> Underway run(Computation<I> what, Consumer<I> then) {
        Underway underway = new Underway();
        try {
            pool.execute(() -> work(what, underway, then));
        } catch (RejectedExecutionException full) {
            then.accept(what.failed("Too much is being worked out already.", clock));
        }
        return underway;
    }

    private <I> void work(Computation<I> what, Underway underway, Consumer<I> then) {
        if (underway.calledOff) {
            return;
        }
        I result;
        try {
            result = what.run(nanoTime, clock, () -> underway.calledOff || pool.isShutdown());
        } catch (RuntimeException e) {
            LOG.error("What an operation asked for could not be worked out", e);
            result = what.failed("The server failed; those who run it find out why in its log.", clock);
        }
        if (!underway.calledOff && !pool.isShutdown()) {
            then.accept(result);
        }
    }

    @Override
    public void close() {
        pool.shutdownNow();
    }
}
