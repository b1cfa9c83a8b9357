package org.dronemap.proxy.mavlink.procedure;

import org.jspecify.annotations.Nullable;

/**
 * How long an answer takes on one link, from measured round trips (smoothed as in RFC 6298, section 2); times in ns.
 * Measure only answers that belong to one question without doubt. Owned by the session's lane.
 */
public final class RoundTrip {
    private static final double SMOOTHING = 1.0 / 8;
    private static final double DEVIATION_SMOOTHING = 1.0 / 4;
    private static final int DEVIATIONS = 4;

    private boolean measured;
    private double smoothedNanos;
    private double deviationNanos;

    public void measured(long nanos) {
        if (nanos < 0) {
            throw new IllegalArgumentException("a round trip cannot take " + nanos + " ns");
        }
        if (measured) {
            deviationNanos += DEVIATION_SMOOTHING * (Math.abs(smoothedNanos - nanos) - deviationNanos);
            smoothedNanos += SMOOTHING * (nanos - smoothedNanos);
        } else {
            measured = true;
            smoothedNanos = nanos;
            deviationNanos = nanos / 2.0;
        }
    }

    /** Null until one was measured. */
    public @Nullable Double smoothedMillis() {
        return measured ? (Double) (smoothedNanos / 1e6) : null;
    }

    /** How long to wait for an answer before asking again, within these bounds; {@code otherwise} before any measure. */
    public long patienceNanos(long least, long most, long otherwise) {
        double patience = measured ? smoothedNanos + DEVIATIONS * deviationNanos : otherwise;
        return Math.max(least, Math.min(most, (long) patience));
    }
}
