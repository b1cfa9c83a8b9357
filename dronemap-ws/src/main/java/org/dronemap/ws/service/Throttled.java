package org.dronemap.ws.service;

import java.time.Duration;

/** Refused because there was too much of it, with how long to wait. */
public final class Throttled extends Rejection {
    private static final long serialVersionUID = 1L;

    private final long retryAfterSeconds;

    private Throttled(String sentence, long retryAfterSeconds) {
        super(RejectionKind.THROTTLED, sentence);
        this.retryAfterSeconds = retryAfterSeconds;
    }

    /** {@code what} was too much, such as {@code Too many commands}; the wait is told in whole seconds, at least one. */
    public static Throttled of(String what, Duration wait) {
        long seconds = Math.max(1, (wait.toMillis() + 999) / 1000);
        return new Throttled(what + "; wait " + seconds + " s and try again.", seconds);
    }

    public long retryAfterSeconds() {
        return retryAfterSeconds;
    }
}
