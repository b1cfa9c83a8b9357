package org.dronemap.proxy.mavlink.procedure;

import org.dronemap.core.command.Outcome;
import org.jspecify.annotations.Nullable;

/**
 * Decides when a transfer with a vehicle is given up: soon if it is heard but silent on it, later if the link is cut.
 * Times in ns.
 */
final class TransferTimeout {
    /** A break of the link may last so long. */
    static final long LONGEST_BREAK_NANOS = 60_000_000_000L;

    static final int TRIES = 9;
    private static final long AUDIBLE_NANOS = 2_000_000_000L;

    private long lastReceivedNanos;
    private long lastNewsNanos;
    private int tries;

    void begin(long nowNanos) {
        lastReceivedNanos = nowNanos;
        progressed(nowNanos);
    }

    /** Any frame of the vehicle. */
    void received(long nowNanos) {
        lastReceivedNanos = nowNanos;
    }

    /** The transfer has come a step forward. */
    void progressed(long nowNanos) {
        lastNewsNanos = nowNanos;
        tries = 0;
    }

    /** The vehicle has said something to the matter, though nothing new. */
    void answered() {
        tries = 0;
    }

    /** Was asked (again); what nobody can hear is no try. */
    void asked(long nowNanos) {
        if (isAudible(nowNanos)) {
            tries++;
        }
    }

    boolean isAudible(long nowNanos) {
        return nowNanos - lastReceivedNanos < AUDIBLE_NANOS;
    }

    long sinceNewsNanos(long nowNanos) {
        return nowNanos - lastNewsNanos;
    }

    /** True when the break has become too long. */
    boolean isBrokenOff(long nowNanos) {
        return nowNanos - lastNewsNanos >= LONGEST_BREAK_NANOS;
    }

    /** Null while it is worth going on. */
    @Nullable
    Outcome end(long nowNanos) {
        boolean ignored = tries >= TRIES && isAudible(nowNanos);
        return ignored || isBrokenOff(nowNanos)
                ? CommandExchange.noAnswer(
                        Math.max(1, sinceNewsNanos(nowNanos) / 1_000_000_000L) * 1_000_000_000L, tries)
                : null;
    }
}
