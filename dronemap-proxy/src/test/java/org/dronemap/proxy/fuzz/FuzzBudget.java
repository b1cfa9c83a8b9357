package org.dronemap.proxy.fuzz;

import java.time.Duration;
import java.util.Random;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;

/** How long to go on, and the seed that makes the same run again ({@code -Ddronemap.fuzz.seed=…}). */
final class FuzzBudget {
    private final BooleanSupplier left;
    private final long seed;
    private final String what;

    private FuzzBudget(String what, long usualSeed, BooleanSupplier left) {
        this.what = what;
        this.left = left;
        seed = Long.getLong("dronemap.fuzz.seed", usualSeed);
        // The ordinary test run has no logger: whoever reads its output needs the seed all the same.
        System.out.println("fuzzing the " + what + " with -Ddronemap.fuzz.seed=" + seed);
    }

    /** So many rounds, the same each time. */
    static FuzzBudget rounds(String what, long rounds) {
        AtomicLong left = new AtomicLong(rounds);
        return new FuzzBudget(what, 1, () -> left.getAndDecrement() > 0);
    }

    /** Others each time, until so much time is over; one round at least. */
    static FuzzBudget lasting(String what, Duration length) {
        long began = System.nanoTime();
        AtomicBoolean first = new AtomicBoolean(true);
        return new FuzzBudget(
                what, began, () -> first.getAndSet(false) || System.nanoTime() - began < length.toNanos());
    }

    Random random() {
        return new Random(seed);
    }

    boolean isLeft() {
        return left.getAsBoolean();
    }

    /** For the message of a failed assertion. */
    String name() {
        return what + ", -Ddronemap.fuzz.seed=" + seed;
    }
}
