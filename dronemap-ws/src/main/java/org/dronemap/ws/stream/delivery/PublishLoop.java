package org.dronemap.ws.stream.delivery;

import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.LockSupport;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The thread that sends updates to stream clients: it runs when woken, or when the last round asked to. Any thread may
 * ask.
 */
public final class PublishLoop implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(PublishLoop.class);
    private static final long LONGEST_NANOS = 40_000_000L;

    private final Pass work;
    private final Thread thread;
    private final AtomicBoolean asked = new AtomicBoolean();
    private volatile boolean closed;

    /** A round of work. */
    public interface Pass {
        Pause round(long nowNanos);
    }

    /** Shortest rest after a round, which no request cuts short, and longest rest. */
    public record Pause(long leastNanos, long mostNanos) {
        /** However long others want. */
        public static final Pause ANY = new Pause(Long.MAX_VALUE, Long.MAX_VALUE);

        /** As long as both allow. */
        public Pause and(Pause other) {
            return new Pause(Math.min(leastNanos, other.leastNanos), Math.min(mostNanos, other.mostNanos));
        }
    }

    public PublishLoop(String name, Pass work) {
        this.work = work;
        thread = new Thread(this::run, name);
        thread.setDaemon(true);
    }

    public void start() {
        thread.start();
    }

    /** Asks for a round; cheap when one is asked for already. */
    public void wake() {
        if (!asked.get() && asked.compareAndSet(false, true)) {
            LockSupport.unpark(thread);
        }
    }

    private void run() {
        while (!closed) {
            long began = System.nanoTime();
            asked.set(false);
            Pause pause = round(began);
            rest(began + pause.leastNanos(), false);
            rest(began + Math.min(LONGEST_NANOS, pause.mostNanos()), true);
        }
    }

    private Pause round(long now) {
        try {
            return work.round(now);
        } catch (RuntimeException e) {
            LOG.error("A round of {} failed", thread.getName(), e);
            return new Pause(LONGEST_NANOS, LONGEST_NANOS);
        }
    }

    private void rest(long untilNanos, boolean untilAsked) {
        while (!closed && !(untilAsked && asked.get())) {
            long left = untilNanos - System.nanoTime();
            if (left <= 0) {
                return;
            }
            LockSupport.parkNanos(this, left);
        }
    }

    @Override
    public void close() {
        closed = true;
        LockSupport.unpark(thread);
    }
}
