package org.dronemap.core.time;

import java.time.Clock;
import java.time.Duration;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.TimeoutException;
import java.util.function.LongSupplier;
import java.util.random.RandomGenerator;

/**
 * Source of clocks, timers and threads for a whole server, so that the same code runs in real or simulated time. Made
 * once, where the server is built, and handed to all that waits, repeats or measures, so that the same code runs in
 * real time and in stepped time. Any thread.
 */
public interface Time {
    /** The time of day, in UTC; it may jump when somebody sets it. */
    Clock clock();

    /** Monotonic time in ns; only differences mean something. */
    long nanos();

    /**
     * Monotonic time in ns for work that goes on until its time is used up. In stepped time each look at it costs the same,
     * so that such work ends after as many rounds on every machine.
     */
    LongSupplier effort();

    /** Chance: what nobody can foretell, or in stepped time the same each time. */
    RandomGenerator random();

    /** An id that nothing else has. */
    default String newId() {
        return new UUID(random().nextLong(), random().nextLong()).toString();
    }

    /** The pieces of work that really go on at the same time; 1 in stepped time. */
    int parallelism();

    /**
     * A thread that does one thing after the other.
     *
     * @param capacity the most that may wait; beyond it work is refused
     */
    Worker worker(String name, int capacity);

    /** A thread that does the same again and again; it begins with {@link Loop#start}. */
    Loop loop(String name, Loop.Turn turn);

    /** Threads that do what is handed to them in any order; beyond {@code capacity} waiting ones, work is refused. */
    Pool pool(String name, int threads, int capacity);

    /**
     * A thread for what waits for bytes of others, which nobody can step; it begins at once and ends with its work.
     *
     * @throws UnsupportedOperationException in stepped time
     */
    Thread blocking(String name, Runnable work);

    /** Waits for what comes of it, at most so long. */
    <T> T await(Future<T> what, Duration longest) throws ExecutionException, TimeoutException, InterruptedException;

    /**
     * Waits for what comes of it, at most so long.
     *
     * @throws CompletionException with what it failed with, a {@link TimeoutException} when that takes longer
     */
    default <T> T join(Future<T> what, Duration longest) {
        try {
            return await(what, longest);
        } catch (ExecutionException e) {
            throw new CompletionException(e.getCause());
        } catch (TimeoutException e) {
            throw new CompletionException(e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new CompletionException(e);
        }
    }

    /** The result, or {@code otherwise} after so long; ends on any thread. */
    <T> CompletableFuture<T> within(CompletableFuture<T> what, Duration longest, T otherwise);
}
