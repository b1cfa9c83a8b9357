package org.dronemap.cognitive.allocate;

import java.time.Duration;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;

/** A limit on a planning search: iterations, time, or until cancelled, as a share used up. */
@FunctionalInterface
public interface SearchBudget {
    /** The share that is used up after so many iterations; 1 and more ends the search. */
    double used(long iterations);

    /** With the same seed the same plan on any machine. */
    static SearchBudget iterations(long most) {
        return iterations -> (double) iterations / most;
    }

    /**
     * From now on.
     *
     * @param nanoTime a monotonic clock
     */
    static SearchBudget time(Duration most, LongSupplier nanoTime) {
        long began = nanoTime.getAsLong();
        double nanos = most.toNanos();
        return iterations -> (nanoTime.getAsLong() - began) / nanos;
    }

    /** The part of it between two shares of it. */
    default SearchBudget part(double from, double to) {
        return iterations -> (used(iterations) - from) / (to - from);
    }

    /** Ends sooner when asked to. */
    default SearchBudget orWhen(BooleanSupplier cancelled) {
        return iterations -> cancelled.getAsBoolean() ? Double.POSITIVE_INFINITY : used(iterations);
    }
}
