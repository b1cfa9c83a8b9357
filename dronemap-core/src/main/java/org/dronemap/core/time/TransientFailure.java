package org.dronemap.core.time;

/** A failure that may be one of the moment, such as of a store that is away or full. */
public interface TransientFailure {
    /** Nothing is wrong with what was asked, only with the moment. */
    boolean isPassing();
}
