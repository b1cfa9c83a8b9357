package org.dronemap.core.conduct;

import org.dronemap.core.operation.SavedOperation;

/** Hears of operations on the conductor's thread, once a change is durable; must return at once. */
@FunctionalInterface
public interface OperationListener {
    /** {@code why}: what people want to read of it, as one or more sentences; empty: nothing. */
    void changed(SavedOperation operation, String why);
}
