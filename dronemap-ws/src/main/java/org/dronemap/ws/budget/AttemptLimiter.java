package org.dronemap.ws.budget;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.Map;
import org.dronemap.ws.problem.RateLimitRejection;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ServerProblem;

/** Limits how often each client may attempt something within a time, such as registering an account. Any thread. */
public final class AttemptLimiter {
    private static final int MOST_REMEMBERED = 10_000;

    private final Clock clock;
    private final int times;
    private final Duration within;

    /** Guarded by this; the one that asked longest ago goes when it is full. */
    private final Map<String, Deque<Instant>> asked = new LinkedHashMap<>(16, 0.75f, true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, Deque<Instant>> eldest) {
            return size() > MOST_REMEMBERED;
        }
    };

    public AttemptLimiter(Clock clock, int times, Duration within) {
        this.clock = clock;
        this.times = times;
        this.within = within;
    }

    /**
     * Counts this time.
     *
     * @throws Rejection when it is one too many, with how long to wait
     */
    public synchronized void acquire(String who, String what) {
        Instant now = clock.instant();
        Deque<Instant> mine = asked.computeIfAbsent(who, unused -> new ArrayDeque<>(times));
        while (!mine.isEmpty() && !mine.peek().plus(within).isAfter(now)) {
            mine.remove();
        }
        if (mine.size() >= times) {
            throw RateLimitRejection.of(
                    ServerProblem.ATTEMPTS_SPENT,
                    "Too many " + what,
                    Duration.between(now, mine.element().plus(within)));
        }
        mine.add(now);
    }
}
