package org.dronemap.mavlink.signing;

import java.time.Instant;
import java.time.InstantSource;

/**
 * The timestamp clock of MAVLink signing: 10 µs steps since 2015-01-01 UTC; it never goes back. Never goes back,
 * whatever the clock of the machine does: it starts at the later of clock and stored time and follows the validly
 * signed frames that are ahead. Not thread-safe.
 */
public final class SigningClock {
    public static final long TICKS_PER_SECOND = 100_000;
    private static final long EPOCH_SECONDS =
            Instant.parse("2015-01-01T00:00:00Z").getEpochSecond();
    private static final long NANOS_PER_TICK = 10_000;
    /** A third of a year below the end of 48 bits: whoever claims the last moment must not stop this clock. */
    private static final long LATEST_FOLLOWED = (1L << 48) - 1 - (1L << 40);

    private final InstantSource clock;
    private long last;

    /** {@code stored}: the timestamp that was kept when the key was last in use, 0 for none. */
    public SigningClock(InstantSource clock, long stored) {
        this.clock = clock;
        last = Math.max(timestampOf(clock.instant()), stored);
    }

    /** The timestamp of a moment; 0 before 2015. */
    public static long timestampOf(Instant moment) {
        long seconds = moment.getEpochSecond() - EPOCH_SECONDS;
        return seconds < 0 ? 0 : seconds * TICKS_PER_SECOND + moment.getNano() / NANOS_PER_TICK;
    }

    /** The latest timestamp that was given or heard, or the clock's when that is later. To be stored every minute. */
    public long now() {
        last = Math.max(last, timestampOf(clock.instant()));
        return last;
    }

    /** A timestamp later than all before. */
    public long next() {
        long now = timestampOf(clock.instant());
        last = Math.max(last + 1, now);
        return last;
    }

    /** A validly signed frame carried this timestamp. */
    void follow(long timestamp) {
        last = Math.max(last, Math.min(timestamp, LATEST_FOLLOWED));
    }
}
