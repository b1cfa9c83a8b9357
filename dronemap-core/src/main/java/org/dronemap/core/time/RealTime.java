package org.dronemap.core.time;

import java.security.SecureRandom;
import java.time.Clock;
import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.LongSupplier;
import java.util.random.RandomGenerator;

/** The {@link Time} of a running server: the machine's clocks and real threads. */
public final class RealTime implements Time {
    private final SecureRandom random = new SecureRandom();
    private final Clock clock;

    public RealTime() {
        this(Clock.systemUTC());
    }

    /** With another clock to tell the time by; monotonic time and pauses are the machine's all the same. */
    public RealTime(Clock clock) {
        this.clock = clock;
    }

    @Override
    public Clock clock() {
        return clock;
    }

    @Override
    public long nanos() {
        return System.nanoTime();
    }

    @Override
    public LongSupplier effort() {
        return System::nanoTime;
    }

    @Override
    public RandomGenerator random() {
        return random;
    }

    @Override
    public int parallelism() {
        return Runtime.getRuntime().availableProcessors();
    }

    @Override
    public Worker worker(String name, int capacity) {
        return new RealTimeWorker(name, capacity);
    }

    @Override
    public Loop loop(String name, Loop.Turn turn) {
        return new RealTimeLoop(name, turn);
    }

    @Override
    public Pool pool(String name, int threads, int capacity) {
        return new RealTimePool(name, threads, capacity);
    }

    @Override
    public Thread blocking(String name, Runnable work) {
        Thread thread = daemon(name, work);
        thread.start();
        return thread;
    }

    @Override
    public <T> T await(Future<T> what, Duration longest)
            throws ExecutionException, TimeoutException, InterruptedException {
        return what.get(longest.toNanos(), TimeUnit.NANOSECONDS);
    }

    @Override
    public <T> CompletableFuture<T> within(CompletableFuture<T> what, Duration longest, T otherwise) {
        return what.copy().completeOnTimeout(otherwise, longest.toNanos(), TimeUnit.NANOSECONDS);
    }

    /** For work that nobody else would do. */
    static Thread onDuty(String name, Runnable work) {
        return FatalErrors.onDuty(daemon(name, work));
    }

    private static Thread daemon(String name, Runnable work) {
        Thread thread = new Thread(work, name);
        thread.setDaemon(true);
        return thread;
    }
}
