package org.dronemap.core.time;

/** A failure that may be only temporary, such as of a store that is out of reach. */
public interface TransientFailure {
    /** Nothing is wrong with what was asked, only with the moment. */
    boolean isTransient();
}
