package org.dronemap.proxy.endpoint;

/**
 * Limits the work that one peer of an endpoint may cause: a token bucket, in units of about one good byte. One unit is
 * about the work of one good byte. Times are monotonic ns. Not thread-safe.
 */
final class TokenBucket {
    private static final int PER_FRAME = 256;
    /** Broken bytes cost many tries at finding a frame in them. */
    private static final int PER_BROKEN_BYTE = 64;

    private static final long SECOND_NANOS = 1_000_000_000L;

    private final long mostPerSecond;
    private long unitsPerSecond;
    private long units;
    private long filledNanos;
    private long grownNanos;

    private TokenBucket(long firstPerSecond, long mostPerSecond, long now) {
        this.unitsPerSecond = firstPerSecond;
        this.mostPerSecond = mostPerSecond;
        this.units = firstPerSecond;
        this.filledNanos = now;
        this.grownNanos = now;
    }

    /** The same for ever. */
    TokenBucket(long unitsPerSecond, long now) {
        this(unitsPerSecond, unitsPerSecond, now);
    }

    /** Twice as much with every second, up to the most: a flood that breaks loose does not hit others with full force. */
    static TokenBucket growing(long firstPerSecond, long mostPerSecond, long now) {
        return new TokenBucket(firstPerSecond, mostPerSecond, now);
    }

    /** What a delivery costs. */
    static long cost(int bytes, long frames, long brokenBytes) {
        return bytes + PER_FRAME * Math.max(1, frames) + PER_BROKEN_BYTE * brokenBytes;
    }

    /** False until time has paid for what was spent. */
    boolean isOpen(long now) {
        grow(now);
        long elapsedMicros = Math.min((now - filledNanos) / 1000, 1_000_000);
        if (elapsedMicros > 0) {
            filledNanos = now;
            units = Math.min(unitsPerSecond, units + elapsedMicros * unitsPerSecond / 1_000_000);
        }
        return units > 0;
    }

    private void grow(long now) {
        while (unitsPerSecond < mostPerSecond && now - grownNanos >= SECOND_NANOS) {
            unitsPerSecond = Math.min(mostPerSecond, 2 * unitsPerSecond);
            grownNanos += SECOND_NANOS;
        }
    }

    /** May go below zero: what has been done is paid for later, at most for ten seconds. */
    void spend(long cost) {
        units = Math.max(units - cost, -10 * unitsPerSecond);
    }
}
