package org.dronemap.core.history;

import java.time.Duration;
import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneOffset;
import org.jspecify.annotations.Nullable;

/**
 * Times for which telemetry is kept in full and then thinned, in days of UTC.
 *
 * @param fullDays so long with all points; 0: never thinned
 * @param keepDays older days go altogether, points and events; 0: for ever
 * @param thinned of older days, what is kept of each stretch of this length: see {@link TelemetryDownsampler}
 */
public record Retention(int fullDays, int keepDays, Duration thinned) {
    /** All points for a month, one in ten seconds for a year. */
    public static final Retention DEFAULT = new Retention(30, 365, Duration.ofSeconds(10));

    public Retention {
        if (fullDays < 0 || keepDays < 0 || thinned.isNegative() || thinned.isZero()) {
            throw new IllegalArgumentException("no such retention: " + fullDays + ", " + keepDays + ", " + thinned);
        }
    }

    /** Days before this one are thinned; null: none. */
    public @Nullable LocalDate firstFull(Instant now) {
        return fullDays == 0 ? null : day(now).minusDays(fullDays);
    }

    /** Days before this one go; null: none. */
    public @Nullable LocalDate firstKept(Instant now) {
        return keepDays == 0 ? null : day(now).minusDays(keepDays);
    }

    private static LocalDate day(Instant now) {
        return LocalDate.ofInstant(now, ZoneOffset.UTC);
    }
}
