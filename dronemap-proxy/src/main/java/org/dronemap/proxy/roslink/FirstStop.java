package org.dronemap.proxy.roslink;

import java.util.function.Consumer;
import org.dronemap.proxy.roslink.wire.Order;

/**
 * Zero speeds for a ground robot that has just called in: it may still drive on with the last speeds of a server that died.
 * Said more than once, since nothing is acknowledged. Without I/O; owned by the session's lane.
 */
final class FirstStop {
    private static final long BETWEEN_NANOS = 150_000_000L;
    private static final int TIMES = 3;

    private final Consumer<Order> send;
    private int left;
    private long sentNanos;

    /** A robot that flies is left alone: speeds mean something to it in some modes only, and count for moments. */
    FirstStop(boolean flies, Consumer<Order> send) {
        this.send = send;
        left = flies ? 0 : TIMES;
    }

    /** Somebody says what it shall do. */
    void cancel() {
        left = 0;
    }

    void tick(long nowNanos) {
        if (left > 0 && (left == TIMES || nowNanos - sentNanos > BETWEEN_NANOS)) {
            left--;
            sentNanos = nowNanos;
            send.accept(Order.Twist.STOP);
        }
    }
}
