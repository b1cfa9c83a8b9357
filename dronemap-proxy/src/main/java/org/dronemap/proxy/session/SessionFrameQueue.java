package org.dronemap.proxy.session;

import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import org.dronemap.core.cloud.lane.Lane;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.Attitude;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.mavlink.message.VfrHud;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The bounded queue of frames from one vehicle that wait to be processed, in order, on the lane of its session.
 * Bounded: what newer news replaces is refused above three quarters, the rest when it is full.
 */
final class SessionFrameQueue {
    private static final Logger LOG = LoggerFactory.getLogger(SessionFrameQueue.class);
    private static final int CAPACITY = 1_024;
    private static final int REPLACEABLE_CAPACITY = CAPACITY - CAPACITY / 4;
    /** So few that a flooded session lets its neighbours on the lane wait less than a millisecond. */
    private static final int AT_ONCE = 64;

    private final Queue<Frame> frames = new ConcurrentLinkedQueue<>();
    private final AtomicInteger waiting = new AtomicInteger();
    private final AtomicBoolean scheduled = new AtomicBoolean();
    private final Consumer<Frame> consumer;
    private volatile Lane lane;

    SessionFrameQueue(Lane lane, Consumer<Frame> consumer) {
        this.lane = lane;
        this.consumer = consumer;
    }

    /** False when there was no room. Any thread. */
    boolean offer(Frame frame) {
        boolean room = waiting.incrementAndGet() <= (isReplaceable(frame) ? REPLACEABLE_CAPACITY : CAPACITY);
        if (room) {
            frames.add(frame);
        } else {
            waiting.decrementAndGet();
        }
        schedule();
        return room;
    }

    /** Frames that wait now. Any thread. */
    int waiting() {
        return waiting.get();
    }

    private static boolean isReplaceable(Frame frame) {
        return switch (frame.messageId()) {
            case GlobalPositionInt.ID, Attitude.ID, VfrHud.ID -> true;
            default -> false;
        };
    }

    /** From now on frames are worked off there. The last thing that the owner does on the old lane. */
    void moveTo(Lane next) {
        lane = next;
    }

    private void schedule() {
        if (!frames.isEmpty() && scheduled.compareAndSet(false, true)) {
            Lane to = lane;
            try {
                to.execute(() -> drain(to));
            } catch (RejectedExecutionException e) {
                scheduled.set(false);
                LOG.debug("A lane had no room; its frames wait in the session", e);
            }
        }
    }

    private void drain(Lane here) {
        try {
            for (int count = 0; count < AT_ONCE && lane == here; count++) {
                Frame frame = frames.poll();
                if (frame == null) {
                    break;
                }
                waiting.decrementAndGet();
                consumer.accept(frame);
            }
        } finally {
            scheduled.set(false);
            schedule();
        }
    }
}
