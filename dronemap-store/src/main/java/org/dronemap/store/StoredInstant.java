package org.dronemap.store;

import java.time.Instant;
import java.time.temporal.ChronoUnit;

/** Times as they are kept: to the microsecond, cut and not rounded, in every adapter alike. */
public final class StoredInstant {
    private StoredInstant() {}

    public static Instant of(Instant time) {
        return time.truncatedTo(ChronoUnit.MICROS);
    }
}
