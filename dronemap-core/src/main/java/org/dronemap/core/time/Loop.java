package org.dronemap.core.time;

import java.time.Duration;

/**
 * A thread that runs one function again and again until it is closed, and can be woken early. Any thread may wake it.
 */
public interface Loop extends AutoCloseable {
    /** One turn. */
    @FunctionalInterface
    interface Turn {
        /** For how many ns it rests afterwards, unless it is woken; 0: there may be more to do at once. */
        long run();
    }

    void start();

    /** The next turn comes now; of several calls before it, one counts. */
    void wake();

    /** No more turns but the one that is being taken. */
    @Override
    void close();

    /** Closes it, and then takes one last turn where the others were taken; false when that takes longer than this. */
    boolean finish(Duration longest);
}
