package org.dronemap.store;

import java.time.Instant;
import java.time.temporal.ChronoUnit;

/** Cuts times to the microsecond, as every kind of store keeps them. */
public final class StoredInstant {
    private StoredInstant() {}

    public static Instant of(Instant time) {
        return time.truncatedTo(ChronoUnit.MICROS);
    }
}
