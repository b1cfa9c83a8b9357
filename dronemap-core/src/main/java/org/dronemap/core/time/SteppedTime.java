package org.dronemap.core.time;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.ZoneId;
import java.time.ZoneOffset;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.TimeoutException;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;
import java.util.random.RandomGenerator;

/**
 * Simulated time for tests: jumps from one due event to the next without waiting, deterministically. All that would be
 * done on threads is done on the one that steps, in the same order each time. That thread alone may use it.
 */
public final class SteppedTime implements Time {
    private static final long MOST_AT_ONE_MOMENT = 1_000_000;

    private final Thread stepper = Thread.currentThread();
    private final SteppedEventQueue agenda = new SteppedEventQueue();
    private final Instant began;
    private final SplittableRandom random;
    private final SteppedProcess itself = new SteppedProcess(this, agenda);
    private long nowNanos;

    /** A server, or whoever else may die while time goes on for others. */
    public interface Killable extends Time {
        /** Nothing that waits here, or is due later, is done any more. */
        void kill();

        /** Stands still from now on, as by SIGSTOP, while time goes on. */
        void stop();

        /** Does all that has been due since. */
        void goOn();
    }

    /** It is {@code began} until it is stepped. */
    public SteppedTime(Instant began) {
        this(began, 1);
    }

    /** The same with a seed of what comes by chance. */
    public SteppedTime(Instant began, long seed) {
        this.began = began;
        this.random = new SplittableRandom(seed);
    }

    /** The same time for something that may die. */
    public Killable killable() {
        return new SteppedProcess(this, agenda);
    }

    /** Does all that is due by now, and what follows from that, until nobody has work left. */
    public void settle() {
        requireStepper();
        long count = 0;
        for (SteppedEventQueue.Entry due = agenda.next(nowNanos); due != null; due = agenda.next(nowNanos)) {
            if (++count > MOST_AT_ONE_MOMENT) {
                throw new IllegalStateException("There is no end of work at " + clock().instant());
            }
            agenda.work(due);
        }
    }

    /** Lets so much time go by, with all that is due in it. */
    public void advance(Duration time) {
        long until = nowNanos + time.toNanos();
        boolean unused = goOnUntil(() -> false, until);
    }

    /** Lets time go by until something holds, which is looked at after each thing that is done; false: not within so long. */
    public boolean advanceUntil(BooleanSupplier holds, Duration longest) {
        return holds.getAsBoolean() || goOnUntil(holds, nowNanos + longest.toNanos());
    }

    private boolean goOnUntil(BooleanSupplier holds, long untilNanos) {
        requireStepper();
        for (SteppedEventQueue.Entry due = agenda.next(untilNanos); due != null; due = agenda.next(untilNanos)) {
            nowNanos = Math.max(nowNanos, due.dueNanos());
            agenda.work(due);
            if (holds.getAsBoolean()) {
                return true;
            }
        }
        nowNanos = Math.max(nowNanos, untilNanos);
        return false;
    }

    /** Failures so far of work that was handed in. */
    public List<RuntimeException> failures() {
        return agenda.failures();
    }

    @Override
    public Clock clock() {
        return new SteppedClock(ZoneOffset.UTC);
    }

    @Override
    public long nanos() {
        return nowNanos;
    }

    @Override
    public LongSupplier effort() {
        return itself.effort();
    }

    @Override
    public RandomGenerator random() {
        return random;
    }

    @Override
    public int parallelism() {
        return itself.parallelism();
    }

    @Override
    public Worker worker(String name, int capacity) {
        return itself.worker(name, capacity);
    }

    @Override
    public Loop loop(String name, Loop.Turn turn) {
        return itself.loop(name, turn);
    }

    @Override
    public Pool pool(String name, int threads, int capacity) {
        return itself.pool(name, threads, capacity);
    }

    @Override
    public Thread blocking(String name, Runnable work) {
        return itself.blocking(name, work);
    }

    @Override
    public <T> T await(Future<T> what, Duration longest)
            throws ExecutionException, TimeoutException, InterruptedException {
        return itself.await(what, longest);
    }

    @Override
    public <T> CompletableFuture<T> within(CompletableFuture<T> what, Duration longest, T otherwise) {
        return itself.within(what, longest, otherwise);
    }

    void requireStepper() {
        if (Thread.currentThread() != stepper) {
            throw new IllegalStateException("Stepped time belongs to " + stepper.getName());
        }
    }

    private final class SteppedClock extends Clock {
        private final ZoneId zone;

        SteppedClock(ZoneId zone) {
            this.zone = zone;
        }

        @Override
        public ZoneId getZone() {
            return zone;
        }

        @Override
        public Clock withZone(ZoneId other) {
            return new SteppedClock(other);
        }

        @Override
        public Instant instant() {
            return began.plusNanos(nowNanos);
        }
    }
}
