package org.dronemap.core.time;

import java.time.Duration;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;

/**
 * Runs tasks one at a time, in the order in which they arrive or become due. What throws is logged, and the next one is
 * done all the same. Any thread may hand work in.
 */
public interface Worker extends Executor, AutoCloseable {
    /**
     * @throws RejectedExecutionException when too much waits, or it is closed
     */
    @Override
    void execute(Runnable work);

    /** Once, after a pause; nothing happens any more when it is closed by then. */
    ScheduledTask after(Duration pause, Runnable work);

    /** Again and again: {@code first} from now on, and then {@code pause} after each end. */
    ScheduledTask every(Duration first, Duration pause, Runnable work);

    /**
     * Does it and tells what came of it.
     *
     * @throws RejectedExecutionException when too much waits, or it is closed
     */
    default <T> Future<T> submit(Callable<T> work) {
        CompletableFuture<T> result = new CompletableFuture<>();
        execute(() -> {
            try {
                result.complete(work.call());
            } catch (Exception e) {
                result.completeExceptionally(e);
            } catch (Error e) {
                result.completeExceptionally(e);
                throw e;
            }
        });
        return result;
    }

    /** For how long it has been at what it does now; zero: it has nothing to do. */
    Duration busyFor();

    /** Handed in and not begun yet. */
    int waiting();

    /** Takes nothing more, and works off what waits already; false when that takes longer than this. */
    boolean finish(Duration longest);

    /** Takes nothing more, and forgets what waits; what is being done is interrupted. */
    @Override
    void close();
}
