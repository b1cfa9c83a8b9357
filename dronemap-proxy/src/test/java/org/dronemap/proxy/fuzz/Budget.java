package org.dronemap.proxy.fuzz;

import java.time.Duration;
import java.util.Random;

/** How long to go on, and the seed that makes the same run again ({@code -Ddronemap.fuzz.seed=…}). */
final class Budget {

    private final long endNanos;
    private final long seed;
    private final String what;

    Budget(String what, Duration length) {
        this.what = what;
        endNanos = System.nanoTime() + length.toNanos();
        seed = Long.getLong("dronemap.fuzz.seed", System.nanoTime());
        // The ordinary test run has no logger: whoever reads its output needs the seed all the same.
        System.out.println("fuzzing the " + what + " with -Ddronemap.fuzz.seed=" + seed);
    }

    Random random() {
        return new Random(seed);
    }

    boolean isLeft() {
        return System.nanoTime() - endNanos < 0;
    }

    /** For the message of a failed assertion. */
    String name() {
        return what + ", -Ddronemap.fuzz.seed=" + seed;
    }
}
