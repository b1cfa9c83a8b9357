package org.dronemap.core.time;

import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;

/**
 * An executor with a few threads and a bounded queue, in real or in stepped time. What throws is logged. Any thread.
 */
public interface Pool extends Executor, AutoCloseable {
    /**
     * @throws RejectedExecutionException when too much waits, or it is closed
     */
    @Override
    void execute(Runnable work);

    /** Takes something that waits away again; false when it does not wait. */
    boolean remove(Runnable work);

    boolean isClosed();

    /** Takes nothing more, and forgets what waits; what is being done is interrupted. */
    @Override
    void close();
}
