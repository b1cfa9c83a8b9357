package org.dronemap.proxy.mavlink.procedure;

import java.util.Locale;

/**
 * Times at which a request to a vehicle is repeated and given up, from the round trip time of its link; at most nine
 * tries. Fixed when the question is first asked, so that the stated deadline holds.
 */
record RetrySchedule(long firstNanos, long longestNanos, long deadlineNanos) {
    private static final int TRIES = 9;
    private static final long LONGEST_NANOS = 900_000_000L;
    private static final double GROWTH = 1.3;

    /** {@code shortestDeadlineNanos}: a slow link gets more. */
    static RetrySchedule of(RoundTripEstimator roundTrip, long shortestDeadlineNanos) {
        long timeout = roundTrip.timeoutNanos();
        long longest = Math.max(timeout, LONGEST_NANOS);
        return new RetrySchedule(timeout, longest, Math.max(shortestDeadlineNanos, (TRIES + 1) * timeout));
    }

    /** For a question that is asked only once. */
    static RetrySchedule single(RoundTripEstimator roundTrip, long shortestDeadlineNanos) {
        long timeout = roundTrip.timeoutNanos();
        return new RetrySchedule(timeout, timeout, Math.max(shortestDeadlineNanos, 3 * timeout));
    }

    /** The pause after that many tries. */
    long pauseNanos(int tries) {
        return (long) Math.min((double) longestNanos, firstNanos * Math.pow(GROWTH, Math.max(0, tries - 1)));
    }

    /** The deadline for people: "8 s". */
    String deadline() {
        double seconds = deadlineNanos / 1e9;
        return seconds == Math.rint(seconds)
                ? String.format(Locale.ROOT, "%.0f s", seconds)
                : String.format(Locale.ROOT, "%.1f s", seconds);
    }
}
