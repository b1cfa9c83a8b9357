package org.dronemap.proxy.fuzz;

import java.time.Duration;
import java.util.Random;

/** How long to go on from the first round on, and the seed that makes the same run again ({@code -Ddronemap.fuzz.seed=…}). */
final class Budget {

    private final Duration length;
    private final long seed;
    private final String what;
    private boolean begun;
    private long endNanos;

    Budget(String what, Duration length) {
        this.what = what;
        this.length = length;
        seed = Long.getLong("dronemap.fuzz.seed", System.nanoTime());
        // The ordinary test run has no logger: whoever reads its output needs the seed all the same.
        System.out.println("fuzzing the " + what + " with -Ddronemap.fuzz.seed=" + seed);
    }

    Random random() {
        return new Random(seed);
    }

    boolean isLeft() {
        if (!begun) {
            // What comes before the first round may take its time on a busy machine.
            begun = true;
            endNanos = System.nanoTime() + length.toNanos();
        }
        return System.nanoTime() - endNanos < 0;
    }

    /** For the message of a failed assertion. */
    String name() {
        return what + ", -Ddronemap.fuzz.seed=" + seed;
    }
}
