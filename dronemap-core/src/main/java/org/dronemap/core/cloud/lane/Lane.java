package org.dronemap.core.cloud.lane;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.LongAdder;
import org.dronemap.core.time.Loop;
import org.dronemap.core.time.Time;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A thread with a task queue that owns the state of a share of the drones. Tasks run in order; ticks run between them
 * every 20 ms. The queue is bounded: telemetry is refused above three quarters (counted), discrete tasks only when it
 * is full.
 */
public final class Lane implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(Lane.class);
    private static final long TICK_NANOS = 20_000_000L;
    /** A turn that takes longer than this is our own stall, and no silence of anybody else. */
    private static final long STALL_NANOS = 250_000_000L;
    /** What was to be done before a stall of this length is not what anybody wants now. */
    private static final long STANDSTILL_NANOS = 5_000_000_000L;
    /** Shorter turns than this are told as one. */
    private static final long TURN_NANOS = 1_000_000L;

    private static final int AT_ONCE = 256;

    /** Something that wants to be called at every tick, on the lane's thread. */
    public interface TimedTask {
        void advance();

        /** The process has stood still for longer than anybody waits; before anything else is done. */
        default void stoodStill(Duration how) {}
    }

    /**
     * Start of the lane's current task or tick, total time that the lane had been stalled by then, and sequence number.
     */
    private record Turn(long beganNanos, long stalledNanos, long number) {}

    private final BlockingQueue<Runnable> tasks;
    private final int telemetryLimit;
    private final LongAdder dropped = new LongAdder();
    private final LongAdder failed = new LongAdder();
    private final String name;
    private final Time time;
    private final Loop loop;
    private volatile boolean closed;
    // Owned by the lane's thread.
    private final ArrayDeque<Runnable> batch = new ArrayDeque<>(AT_ONCE);
    private final List<TimedTask> tickers = new ArrayList<>();
    private long lastTickNanos;
    private volatile Turn turn;

    public Lane(Time time, String name, int capacity) {
        this.time = time;
        this.name = name;
        tasks = new ArrayBlockingQueue<>(capacity);
        telemetryLimit = capacity / 4;
        lastTickNanos = time.nanos();
        turn = new Turn(lastTickNanos, 0, 0);
        loop = time.loop(name, this::work);
        loop.start();
    }

    /** For what newer news replaces: false, and counted, when the lane is too busy. */
    public boolean offer(Runnable telemetry) {
        if (tasks.remainingCapacity() <= telemetryLimit || !tasks.offer(telemetry)) {
            dropped.increment();
            return false;
        }
        loop.wake();
        return true;
    }

    /** For what must not be lost without a word. */
    public void execute(Runnable discrete) {
        if (closed || !tasks.offer(discrete)) {
            throw new RejectedExecutionException("the lane " + name + " is full or closed");
        }
        loop.wake();
    }

    /** Adds a ticker; from the lane's thread only. */
    public void addTimedTask(TimedTask ticker) {
        tickers.add(ticker);
    }

    /** Removes a ticker; from the lane's thread only. */
    public void removeTimedTask(TimedTask ticker) {
        tickers.remove(ticker);
    }

    /** Monotonic time in ns that stands still while this process does: for judging the silence of others. */
    public long activeNanos() {
        Turn now = turn;
        return now.beganNanos() + Math.min(time.nanos() - now.beganNanos(), STALL_NANOS) - now.stalledNanos();
    }

    public String name() {
        return name;
    }

    /** Grows as long as the lane moves, at least fifty times a second when it has nothing to do. */
    public long turns() {
        return turn.number();
    }

    /** For how long it has been at the same task; what stands still while this process does counts as well. */
    public Duration atTheSame() {
        return Duration.ofNanos(Math.max(0, time.nanos() - turn.beganNanos()));
    }

    /** Telemetry refused since the start. */
    public long droppedCount() {
        return dropped.sum();
    }

    /** Tasks and ticks that threw, each logged. */
    public long failedCount() {
        return failed.sum();
    }

    private long work() {
        boolean any = tasks.drainTo(batch, AT_ONCE) > 0;
        for (Runnable task = batch.poll(); task != null && !closed; task = batch.poll()) {
            // Before the task, which may judge a silence that was our own.
            noticeStall();
            guard(task);
            runTimedTasksWhenDue();
        }
        noticeStall();
        runTimedTasksWhenDue();
        return any ? 0 : TICK_NANOS;
    }

    private void noticeStall() {
        Turn before = turn;
        long gap = time.nanos() - before.beganNanos();
        if (gap < TURN_NANOS) {
            return;
        }
        turn = new Turn(
                before.beganNanos() + gap, before.stalledNanos() + Math.max(0, gap - STALL_NANOS), before.number() + 1);
        if (gap > STALL_NANOS) {
            LOG.warn("Lane {} stood still for {} ms; nobody is called lost for it", name, gap / 1_000_000);
        }
        if (gap > STANDSTILL_NANOS) {
            List.copyOf(tickers).forEach(ticker -> guard(() -> ticker.stoodStill(Duration.ofNanos(gap))));
        }
    }

    private void runTimedTasksWhenDue() {
        long gap = time.nanos() - lastTickNanos;
        if (gap < TICK_NANOS) {
            return;
        }
        lastTickNanos += gap;
        for (TimedTask ticker : List.copyOf(tickers)) {
            guard(ticker::advance);
        }
    }

    private void guard(Runnable work) {
        try {
            work.run();
        } catch (RuntimeException e) {
            failed.increment();
            LOG.error("A task of lane {} failed", name, e);
        }
    }

    @Override
    public void close() {
        closed = true;
        loop.close();
    }
}
