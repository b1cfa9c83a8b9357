package org.dronemap.proxy.endpoint;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Map;
import org.dronemap.core.link.ClientHost;

/**
 * Makes hosts whose WebSockets were cut for exceeding limits wait before they are read again, longer each time. Whoever
 * comes from there next waits, longer each time: coming anew costs a stranger nothing, and the server a handshake and
 * all that is said until the next cut. Who made a mistake, or has a neighbour behind the same address, waits, but is
 * not turned away. Not thread-safe.
 */
final class HostBackoff {
    /** So many are a mistake. */
    private static final int FREE = 3;

    private static final long FIRST_PAUSE_NANOS = Duration.ofMillis(125).toNanos();
    private static final long REMEMBERED_NANOS = Duration.ofMinutes(1).toNanos();
    private static final int MOST_DOUBLINGS = 30;
    private static final int MOST_HOSTS = 10_000;

    private final long longestPauseNanos;
    private final Map<ClientHost, History> histories = new LinkedHashMap<>() {
        @Override
        protected boolean removeEldestEntry(Map.Entry<ClientHost, History> eldest) {
            return size() > MOST_HOSTS;
        }
    };

    private record History(int count, long lastNanos) {
        boolean isOver(long now) {
            return now - lastNanos > REMEMBERED_NANOS;
        }
    }

    HostBackoff(Duration longestPause) {
        longestPauseNanos = longestPause.toNanos();
    }

    void add(ClientHost host, long now) {
        History before = histories.get(host);
        histories.put(host, new History(before == null || before.isOver(now) ? 1 : before.count + 1, now));
    }

    /** How long who comes from there now has to wait. */
    long pauseNanos(ClientHost host, long now) {
        History history = histories.get(host);
        if (history == null || history.isOver(now) || history.count <= FREE) {
            return 0;
        }
        int doublings = Math.min(history.count - FREE - 1, MOST_DOUBLINGS);
        return Math.min(longestPauseNanos, FIRST_PAUSE_NANOS << doublings);
    }

    void forget(long now) {
        histories.values().removeIf(history -> history.isOver(now));
    }
}
