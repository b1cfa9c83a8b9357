package org.dronemap.ws.security;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.Map;
import org.dronemap.ws.problem.RateLimitRejection;
import org.dronemap.ws.problem.ServerProblem;

/**
 * Slows down password guessing at the sign-in: each wrong password doubles a wait, from 30 s up to 15 min. Counted for
 * one name from one place, for one place whatever the name, and for one name wherever from; the last one spares the
 * places from which that user has signed in before, so that nobody can lock somebody else out. Any thread.
 */
final class SignInThrottle {
    private static final int OF_NAME_FROM_PLACE = 5;
    private static final int FROM_PLACE = 30;
    private static final int OF_NAME = 100;
    private static final Duration FIRST_REST = Duration.ofSeconds(30);
    private static final Duration LONGEST_REST = Duration.ofMinutes(15);
    private static final int MOST_REMEMBERED = 10_000;

    private final Clock clock;
    // both guarded by this
    private final Map<AttemptKey, Attempts> attempts = new Recent<>();
    private final Map<AttemptKey, Boolean> rightBefore = new Recent<>();

    /** An empty part: any. */
    private record AttemptKey(String name, String address) {}

    private record Attempts(int wrong, Instant last) {}

    /** The one that was used longest ago goes when it is full. */
    private static final class Recent<V> extends LinkedHashMap<AttemptKey, V> {
        private static final long serialVersionUID = 1L;

        Recent() {
            super(16, 0.75f, true);
        }

        @Override
        protected boolean removeEldestEntry(Map.Entry<AttemptKey, V> eldest) {
            return size() > MOST_REMEMBERED;
        }
    }

    SignInThrottle(Clock clock) {
        this.clock = clock;
    }

    synchronized void check(String name, String address) {
        AttemptKey pair = new AttemptKey(name, address);
        check(pair, OF_NAME_FROM_PLACE);
        check(new AttemptKey("", address), FROM_PLACE);
        if (!rightBefore.containsKey(pair)) {
            check(new AttemptKey(name, ""), OF_NAME);
        }
    }

    private void check(AttemptKey who, int allowed) {
        Attempts before = attempts.get(who);
        if (before == null || before.wrong() < allowed) {
            return;
        }
        Duration left = Duration.between(clock.instant(), before.last().plus(rest(before.wrong() - allowed)));
        if (left.isNegative() || left.isZero()) {
            return;
        }
        throw RateLimitRejection.of(ServerProblem.ATTEMPTS_SPENT, "Too many wrong passwords", left);
    }

    private static Duration rest(int doublings) {
        Duration rest = FIRST_REST.multipliedBy(1L << Math.min(doublings, 10));
        return rest.compareTo(LONGEST_REST) < 0 ? rest : LONGEST_REST;
    }

    synchronized void wrong(String name, String address) {
        count(new AttemptKey(name, address));
        count(new AttemptKey("", address));
        count(new AttemptKey(name, ""));
    }

    private void count(AttemptKey who) {
        attempts.merge(
                who, new Attempts(1, clock.instant()), (before, now) -> new Attempts(before.wrong() + 1, now.last()));
    }

    synchronized void right(String name, String address) {
        attempts.remove(new AttemptKey(name, address));
        attempts.remove(new AttemptKey("", address));
        rightBefore.put(new AttemptKey(name, address), true);
    }
}
