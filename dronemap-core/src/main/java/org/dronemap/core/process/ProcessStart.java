package org.dronemap.core.process;

import org.jspecify.annotations.Nullable;

/**
 * Start of this process: the crash before it, if any, and the guard against peers that caused crashes.
 *
 * @param before how the one before it ended; null: it was stopped, or there was none
 * @param watch for whoever takes bytes of peers
 */
public record ProcessStart(@Nullable ProcessCrash before, PeerCrashGuard watch) {
    /** There is nothing to be said of it. */
    public static final ProcessStart ORDINARY = new ProcessStart(null, PeerCrashGuard.NONE);

    public SafeMode precautions() {
        return watch.precautions();
    }
}
