package org.dronemap.proxy.outlet;

import java.time.Clock;
import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;
import java.util.random.RandomGenerator;
import org.dronemap.core.time.Loop;
import org.dronemap.core.time.Pool;
import org.dronemap.core.time.RealTime;
import org.dronemap.core.time.Time;
import org.dronemap.core.time.Worker;

/** The machine's time, whose monotonic part a test may let jump ahead; nobody wakes earlier for that. */
final class JumpingTime implements Time {
    private final Time real = new RealTime();
    private final AtomicLong jumped = new AtomicLong();

    void jump(Duration ahead) {
        jumped.addAndGet(ahead.toNanos());
    }

    @Override
    public long nanos() {
        return real.nanos() + jumped.get();
    }

    @Override
    public Clock clock() {
        return real.clock();
    }

    @Override
    public LongSupplier effort() {
        return real.effort();
    }

    @Override
    public RandomGenerator random() {
        return real.random();
    }

    @Override
    public int parallelism() {
        return real.parallelism();
    }

    @Override
    public Worker worker(String name, int capacity) {
        return real.worker(name, capacity);
    }

    @Override
    public Loop loop(String name, Loop.Turn turn) {
        return real.loop(name, turn);
    }

    @Override
    public Pool pool(String name, int threads, int capacity) {
        return real.pool(name, threads, capacity);
    }

    @Override
    public Thread blocking(String name, Runnable work) {
        return real.blocking(name, work);
    }

    @Override
    public <T> T await(Future<T> what, Duration longest)
            throws ExecutionException, TimeoutException, InterruptedException {
        return real.await(what, longest);
    }

    @Override
    public <T> CompletableFuture<T> within(CompletableFuture<T> what, Duration longest, T otherwise) {
        return real.within(what, longest, otherwise);
    }
}
