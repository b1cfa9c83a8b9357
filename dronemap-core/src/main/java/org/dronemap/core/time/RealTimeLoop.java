package org.dronemap.core.time;

import java.time.Duration;
import java.util.concurrent.locks.LockSupport;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** A {@link Loop} on a real thread of its own. */
final class RealTimeLoop implements Loop {
    private static final Logger LOG = LoggerFactory.getLogger(RealTimeLoop.class);

    private final Turn turn;
    private final Thread thread;
    private volatile boolean closed;
    private volatile boolean finishing;
    private volatile boolean woken;
    private volatile boolean asleep;

    RealTimeLoop(String name, Turn turn) {
        this.turn = turn;
        thread = RealTime.onDuty(name, this::run);
    }

    @Override
    public void start() {
        thread.start();
    }

    @Override
    public void wake() {
        woken = true;
        if (asleep) {
            LockSupport.unpark(thread);
        }
    }

    private void run() {
        WaitStrategy rhythm = new WaitStrategy();
        boolean found = false;
        while (!closed) {
            long rest = runTurn();
            if (rest > 0) {
                rhythm.pause(found, () -> sleep(rest));
            }
            found = rest <= 0;
        }
        if (finishing) {
            runTurn();
        }
    }

    private void sleep(long nanos) {
        asleep = true;
        if (!woken && !closed) {
            LockSupport.parkNanos(this, nanos);
        }
        asleep = false;
        woken = false;
    }

    /** A turn that fails is tried again after a pause. */
    private long runTurn() {
        try {
            return turn.run();
        } catch (RuntimeException e) {
            LOG.error("A turn of {} failed; it goes on with the next", thread.getName(), e);
            return Duration.ofMillis(100).toNanos();
        }
    }

    @Override
    public void close() {
        closed = true;
        LockSupport.unpark(thread);
    }

    @Override
    public boolean finish(Duration longest) {
        finishing = true;
        close();
        try {
            thread.join(longest.toMillis());
            return !thread.isAlive();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return false;
        }
    }
}
