package org.dronemap.core.time;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.ZoneId;
import java.time.ZoneOffset;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.TimeoutException;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;

/**
 * Time that goes on only when it is told to, from one thing that is due to the next, without waiting. All that would be done
 * on threads is done on the one that steps, in the same order each time. That thread alone may use it.
 */
public final class SteppedTime implements Time {
    private static final long MOST_AT_ONE_MOMENT = 1_000_000;
    /** What one look at {@link #effort} costs. */
    private static final long LOOK_NANOS = 4_000_000;

    private final Thread stepper = Thread.currentThread();
    private final Agenda agenda = new Agenda();
    private final Agenda.Owner waits = new Agenda.Owner("what waits");
    private final Instant began;
    private long nowNanos;

    /** It is {@code began} until it is stepped. */
    public SteppedTime(Instant began) {
        this.began = began;
    }

    /** Does all that is due by now, and what follows from that, until nobody has work left. */
    public void settle() {
        requireStepper();
        long count = 0;
        for (Agenda.Entry due = agenda.next(nowNanos); due != null; due = agenda.next(nowNanos)) {
            if (++count > MOST_AT_ONE_MOMENT) {
                throw new IllegalStateException("There is no end of work at " + clock().instant());
            }
            agenda.work(due);
        }
    }

    /** Lets so much time go by, with all that is due in it. */
    public void advance(Duration time) {
        long until = nowNanos + time.toNanos();
        boolean unused = advanceUntil(() -> false, until);
    }

    /** Lets time go by until something holds, which is looked at after each thing that is done; false: not within so long. */
    public boolean advanceUntil(BooleanSupplier holds, Duration longest) {
        settle();
        return holds.getAsBoolean() || advanceUntil(holds, nowNanos + longest.toNanos());
    }

    /** What failed so far in work that was handed in. */
    public List<RuntimeException> failures() {
        return agenda.failures();
    }

    private boolean advanceUntil(BooleanSupplier holds, long untilNanos) {
        requireStepper();
        for (Agenda.Entry due = agenda.next(untilNanos); due != null; due = agenda.next(untilNanos)) {
            nowNanos = Math.max(nowNanos, due.dueNanos());
            agenda.work(due);
            if (holds.getAsBoolean()) {
                return true;
            }
        }
        nowNanos = Math.max(nowNanos, untilNanos);
        return false;
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
        return new Effort(nowNanos);
    }

    @Override
    public int parallelism() {
        return 1;
    }

    @Override
    public Worker worker(String name, int capacity) {
        return new SteppedWorker(this, agenda, name, capacity);
    }

    @Override
    public Loop loop(String name, Loop.Turn turn) {
        return new SteppedLoop(this, agenda, name, turn);
    }

    @Override
    public Pool pool(String name, int threads, int capacity) {
        return new SteppedPool(worker(name, threads + capacity));
    }

    @Override
    public Thread blocking(String name, Runnable work) {
        throw new UnsupportedOperationException("Nobody can step what waits for bytes: " + name);
    }

    @Override
    public <T> T await(Future<T> what, Duration longest)
            throws ExecutionException, TimeoutException, InterruptedException {
        settle();
        if (!what.isDone() && !advanceUntil(what::isDone, nowNanos + longest.toNanos())) {
            throw new TimeoutException("not within " + longest);
        }
        return what.get();
    }

    @Override
    public <T> CompletableFuture<T> within(CompletableFuture<T> what, Duration longest, T otherwise) {
        CompletableFuture<T> first = what.copy();
        Agenda.Entry end = agenda.add(waits, nowNanos + longest.toNanos(), () -> first.complete(otherwise));
        return first.whenComplete((value, failure) -> agenda.remove(end));
    }

    void requireStepper() {
        if (Thread.currentThread() != stepper) {
            throw new IllegalStateException("Stepped time belongs to " + stepper.getName());
        }
    }

    private static final class Effort implements LongSupplier {
        private long nanos;

        Effort(long nanos) {
            this.nanos = nanos;
        }

        @Override
        public long getAsLong() {
            nanos += LOOK_NANOS;
            return nanos;
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
