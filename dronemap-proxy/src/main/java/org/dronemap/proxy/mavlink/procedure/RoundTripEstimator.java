package org.dronemap.proxy.mavlink.procedure;

import org.jspecify.annotations.Nullable;

/**
 * Estimates the round trip time of one vehicle link, smoothed as in RFC 6298, section 2; times in ns. Measure only
 * answers that belong to one question without doubt. Owned by the session's lane.
 */
public final class RoundTripEstimator {
    private static final double SMOOTHING = 1.0 / 8;
    private static final double DEVIATION_SMOOTHING = 1.0 / 4;
    private static final int DEVIATIONS = 4;
    private static final double STRETCHING = 1.5;
    private static final double LONGEST_STRETCH = 4;
    /** What is assumed before anything was measured. */
    static final long FIRST_TIMEOUT_NANOS = 800_000_000L;

    private static final long SHORTEST_TIMEOUT_NANOS = 200_000_000L;
    private static final long LONGEST_TIMEOUT_NANOS = 3_000_000_000L;

    private boolean measured;
    private double smoothedNanos;
    private double deviationNanos;
    private double stretch = 1;

    public void measured(long nanos) {
        if (nanos < 0) {
            throw new IllegalArgumentException("a round trip cannot take " + nanos + " ns");
        }
        stretch = 1;
        if (measured) {
            deviationNanos += DEVIATION_SMOOTHING * (Math.abs(smoothedNanos - nanos) - deviationNanos);
            smoothedNanos += SMOOTHING * (nanos - smoothedNanos);
        } else {
            measured = true;
            smoothedNanos = nanos;
            deviationNanos = nanos / 2.0;
        }
    }

    /** A question had to be repeated, so that its answer measures nothing: wait longer until another one does (Karn). */
    public void repeated() {
        stretch = Math.min(LONGEST_STRETCH, stretch * STRETCHING);
    }

    /** Null until one was measured. */
    public @Nullable Double smoothedMillis() {
        return measured ? (Double) (smoothedNanos / 1e6) : null;
    }

    /** How long to wait for an answer before asking again, within these bounds; {@code otherwise} before any measure. */
    public long patienceNanos(long least, long most, long otherwise) {
        double patience = measured ? smoothedNanos + DEVIATIONS * deviationNanos : otherwise;
        return Math.max(least, Math.min(most, (long) (patience * stretch)));
    }

    /** After so long the answer to a command is overdue. */
    long timeoutNanos() {
        return patienceNanos(SHORTEST_TIMEOUT_NANOS, LONGEST_TIMEOUT_NANOS, FIRST_TIMEOUT_NANOS);
    }
}
