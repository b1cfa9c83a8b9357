package org.dronemap.ws.security;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.Map;
import org.dronemap.ws.service.Rejection;
import org.dronemap.ws.service.RejectionKind;

/** Makes guessing slow: after five wrong passwords in a row from one place for one name, 30 s of rest. Any thread. */
final class SignInThrottle {
    private static final int WRONG_IN_A_ROW = 5;
    private static final Duration REST = Duration.ofSeconds(30);
    private static final int MOST_REMEMBERED = 10_000;

    private final Clock clock;

    /** Guarded by this; the eldest goes when it is full. */
    private final Map<Who, Attempts> attempts = new LinkedHashMap<>(16, 0.75f, true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<Who, Attempts> eldest) {
            return size() > MOST_REMEMBERED;
        }
    };

    private record Who(String name, String address) {}

    private record Attempts(int wrong, Instant last) {}

    SignInThrottle(Clock clock) {
        this.clock = clock;
    }

    synchronized void check(String name, String address) {
        Attempts before = attempts.get(new Who(name, address));
        if (before == null || before.wrong() < WRONG_IN_A_ROW) {
            return;
        }
        Duration left = Duration.between(clock.instant(), before.last().plus(REST));
        if (left.isNegative() || left.isZero()) {
            return;
        }
        throw new Rejection(
                RejectionKind.THROTTLED,
                "Too many wrong passwords; wait " + (left.toSeconds() + 1) + " s and try again.");
    }

    synchronized void wrong(String name, String address) {
        attempts.merge(
                new Who(name, address),
                new Attempts(1, clock.instant()),
                (before, now) -> new Attempts(before.wrong() + 1, now.last()));
    }

    synchronized void right(String name, String address) {
        attempts.remove(new Who(name, address));
    }
}
