package org.dronemap.core.operation;

import java.time.Clock;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;

/** Work that takes long: all that it needs is in it, written down with the decision that asks for it. */
public interface Computation<I> {
    /** Runs on a thread of its own; ends early when cancelled. */
    I run(LongSupplier nanoTime, Clock clock, BooleanSupplier cancelled);

    /** What comes back when it could not be run: it failed, or nobody has room for it. */
    I failed(String why, Clock clock);
}
