package org.dronemap.core.operation;

import java.time.InstantSource;
import java.util.function.BooleanSupplier;
import org.dronemap.core.time.Time;

/** A long computation that an operation asks for, such as planning; contains all its input. */
public interface Computation<I> {
    /** Runs on a thread of its own; ends early when cancelled. */
    I run(Time time, BooleanSupplier cancelled);

    /** What comes back when it could not be run: it failed, or nobody has room for it. */
    I failed(String why, InstantSource clock);
}
