package org.dronemap.core.conduct;

import org.dronemap.core.operation.SavedOperation;

/** Is told of each change of an operation (a mission run or a follow) once it is durable; must return at once. */
@FunctionalInterface
public interface OperationListener {
    /** {@code why}: what people want to read of it, as one or more sentences; empty: nothing. */
    void changed(SavedOperation operation, String why);
}
