package org.dronemap.core.time;

import java.time.Clock;
import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.TimeoutException;
import java.util.function.LongSupplier;
import java.util.random.RandomGenerator;

/** A process simulated in stepped time for tests, such as one server, which can be killed without the others. */
final class SteppedProcess implements SteppedTime.Killable {
    /** The price of one look at {@link #effort}. */
    private static final long LOOK_NANOS = 4_000_000;

    private final SteppedTime time;
    private final SteppedEventQueue agenda;
    private final SteppedEventQueue.Lifetime life = new SteppedEventQueue.Lifetime();
    private final SteppedEventQueue.Owner waits = new SteppedEventQueue.Owner("what waits", life);

    SteppedProcess(SteppedTime time, SteppedEventQueue agenda) {
        this.time = time;
        this.agenda = agenda;
    }

    @Override
    public void kill() {
        life.stopped(false);
        life.end();
    }

    @Override
    public void stop() {
        life.stopped(true);
    }

    @Override
    public void goOn() {
        life.stopped(false);
    }

    void settle() {
        time.settle();
    }

    void requireStepper() {
        time.requireStepper();
    }

    @Override
    public Clock clock() {
        return time.clock();
    }

    @Override
    public long nanos() {
        return time.nanos();
    }

    @Override
    public LongSupplier effort() {
        return new Effort(time.nanos());
    }

    @Override
    public RandomGenerator random() {
        return time.random();
    }

    @Override
    public int parallelism() {
        return 1;
    }

    @Override
    public Worker worker(String name, int capacity) {
        return new SteppedWorker(this, agenda, life, name, capacity);
    }

    @Override
    public Loop loop(String name, Loop.Turn turn) {
        return new SteppedLoop(this, agenda, life, name, turn);
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
        if (!time.advanceUntil(what::isDone, longest)) {
            throw new TimeoutException("not within " + longest);
        }
        return what.get();
    }

    @Override
    public <T> CompletableFuture<T> within(CompletableFuture<T> what, Duration longest, T otherwise) {
        CompletableFuture<T> first = what.copy();
        SteppedEventQueue.Entry end =
                agenda.add(waits, time.nanos() + longest.toNanos(), () -> first.complete(otherwise));
        return first.whenComplete((value, failure) -> agenda.remove(end));
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
}
