package org.dronemap.core.process;

import org.jspecify.annotations.Nullable;

/**
 * The beginning of this process.
 *
 * @param before how the one before it ended; null: it was stopped, or there was none
 * @param watch for whoever takes bytes of peers
 */
public record Beginning(@Nullable PastEnd before, PeerWatch watch) {
    /** There is nothing to be said of it. */
    public static final Beginning ORDINARY = new Beginning(null, PeerWatch.NONE);

    public Precautions precautions() {
        return watch.precautions();
    }
}
