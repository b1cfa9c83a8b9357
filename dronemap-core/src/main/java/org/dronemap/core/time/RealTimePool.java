package org.dronemap.core.time;

import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** A {@link Pool} of a few real threads. */
final class RealTimePool implements Pool {
    private static final Logger LOG = LoggerFactory.getLogger(RealTimePool.class);

    private final String name;
    private final ThreadPoolExecutor threads;

    RealTimePool(String name, int threads, int capacity) {
        this.name = name;
        AtomicInteger numbers = new AtomicInteger();
        BlockingQueue<Runnable> queue = capacity == 0 ? new SynchronousQueue<>() : new ArrayBlockingQueue<>(capacity);
        this.threads = new ThreadPoolExecutor(
                threads,
                threads,
                0,
                TimeUnit.SECONDS,
                queue,
                work -> RealTime.onDuty(name + "-" + numbers.incrementAndGet(), work));
    }

    @Override
    public void execute(Runnable work) {
        threads.execute(new Guarded(name, work));
    }

    /** Equal to another one of the same work, which is how a waiting one is found. */
    private record Guarded(String name, Runnable work) implements Runnable {
        @Override
        public void run() {
            try {
                work.run();
            } catch (RuntimeException e) {
                LOG.error("Something handed to {} failed", name, e);
            }
        }
    }

    @Override
    public boolean remove(Runnable work) {
        return threads.remove(new Guarded(name, work));
    }

    @Override
    public boolean isClosed() {
        return threads.isShutdown();
    }

    @Override
    public void close() {
        threads.shutdownNow();
    }
}
