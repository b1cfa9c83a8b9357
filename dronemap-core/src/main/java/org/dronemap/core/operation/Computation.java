package org.dronemap.core.operation;

import java.time.InstantSource;
import java.util.function.BooleanSupplier;
import org.dronemap.core.time.Time;

/** Work that takes long: all that it needs is in it, written down with the decision that asks for it. */
public interface Computation<I> {
    /** Runs on a thread of its own; ends early when cancelled. */
    I run(Time time, BooleanSupplier cancelled);

    /** What comes back when it could not be run: it failed, or nobody has room for it. */
    I failed(String why, InstantSource clock);
}
