package org.dronemap.ws.violation;

import java.io.IOException;
import java.nio.channels.Selector;
import java.time.Clock;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Timer;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.Future;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.Semaphore;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.locks.LockSupport;
import java.util.function.LongSupplier;
import java.util.stream.Stream;
import org.dronemap.core.time.Time;
import org.dronemap.core.time.WaitStrategy;

/** Ways to have time and threads of one's own, one each. */
public final class TimeViolations {
    private TimeViolations() {}

    static final class Monotonic {
        long now() {
            return System.nanoTime();
        }
    }

    static final class MonotonicHandedOn {
        LongSupplier now() {
            return System::nanoTime;
        }
    }

    static final class Millis {
        long now() {
            return System.currentTimeMillis();
        }
    }

    static final class Now {
        Instant now() {
            return Instant.now();
        }
    }

    static final class SystemClock {
        Clock clock() {
            return Clock.systemUTC();
        }
    }

    static final class SystemSource {
        InstantSource source() {
            return InstantSource.system();
        }
    }

    static final class OwnThread {
        Thread thread(Runnable work) {
            return new Thread(work);
        }
    }

    static final class OwnTimer {
        Timer timer() {
            return new Timer();
        }
    }

    static final class MadeByExecutors {
        ExecutorService pool() {
            return Executors.newCachedThreadPool();
        }
    }

    static final class MadePool {
        ExecutorService pool() {
            return new ThreadPoolExecutor(1, 1, 0, TimeUnit.SECONDS, new LinkedBlockingQueue<>());
        }
    }

    static final class MadeSchedule {
        ExecutorService pool() {
            return new ScheduledThreadPoolExecutor(1);
        }
    }

    static final class MadeForks {
        ExecutorService pool() {
            return new ForkJoinPool(2);
        }
    }

    static final class CommonPool {
        ExecutorService pool() {
            return ForkJoinPool.commonPool();
        }
    }

    static final class SuppliedAnywhere {
        CompletableFuture<Integer> work() {
            return CompletableFuture.supplyAsync(() -> 1);
        }
    }

    static final class RunAnywhere {
        CompletableFuture<Void> work(Runnable work) {
            return CompletableFuture.runAsync(work);
        }
    }

    static final class FollowedAnywhere {
        CompletableFuture<Integer> work(CompletableFuture<Integer> before) {
            return before.thenApplyAsync(value -> value + 1);
        }
    }

    static final class Parallel {
        Stream<Integer> work(List<Integer> all) {
            return all.parallelStream();
        }
    }

    static final class Delayed {
        Executor later(Executor executor) {
            return CompletableFuture.delayedExecutor(1, TimeUnit.SECONDS, executor);
        }
    }

    static final class OrTimeout {
        CompletableFuture<Integer> within(CompletableFuture<Integer> work) {
            return work.orTimeout(1, TimeUnit.SECONDS);
        }
    }

    static final class CompletedOnTimeout {
        CompletableFuture<Integer> within(CompletableFuture<Integer> work) {
            return work.completeOnTimeout(1, 1, TimeUnit.SECONDS);
        }
    }

    static final class Sleeping {
        void rest() throws InterruptedException {
            Thread.sleep(1);
        }
    }

    static final class SleepingAUnit {
        void rest() throws InterruptedException {
            TimeUnit.SECONDS.sleep(1);
        }
    }

    static final class Parked {
        void rest() {
            LockSupport.parkNanos(this, 1);
        }
    }

    static final class Waiting {
        private boolean done;

        synchronized void rest() throws InterruptedException {
            while (!done) {
                wait(1);
            }
        }

        synchronized void end() {
            done = true;
            notifyAll();
        }
    }

    static final class Polling {
        Object next(BlockingQueue<Object> queue) throws InterruptedException {
            return String.valueOf(queue.poll(1, TimeUnit.SECONDS));
        }
    }

    static final class Awaiting {
        boolean done(CountDownLatch latch) throws InterruptedException {
            return latch.await(1, TimeUnit.SECONDS);
        }
    }

    static final class Acquiring {
        boolean done(Semaphore semaphore) throws InterruptedException {
            return semaphore.tryAcquire(1, TimeUnit.SECONDS);
        }
    }

    static final class Getting {
        Object result(Future<Object> future) throws InterruptedException, ExecutionException, TimeoutException {
            return future.get(1, TimeUnit.SECONDS);
        }
    }

    static final class AwaitingTheEnd {
        boolean done(ExecutorService pool) throws InterruptedException {
            return pool.awaitTermination(1, TimeUnit.SECONDS);
        }
    }

    static final class Selecting {
        int ready(Selector selector) throws IOException {
            return selector.select(1);
        }
    }

    static final class Resting {
        void rest() {
            new WaitStrategy().pause(false, () -> {});
        }
    }

    /** As it should be. */
    public static final class FromOutside {
        private final Time time;

        FromOutside(Time time) {
            this.time = time;
        }

        Instant now() {
            return Instant.now(time.clock());
        }

        long nanos() {
            return time.nanos() + TimeUnit.SECONDS.toNanos(1);
        }

        CompletableFuture<Integer> work(Executor executor) {
            return CompletableFuture.supplyAsync(() -> 1, executor).thenApply(value -> value + 1);
        }
    }
}
