package org.dronemap.core.history;

import java.time.Instant;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * A gap in the numbered series of events: some that happened in that time are missing.
 *
 * @param number the place in the series; later events have higher numbers
 * @param from null: not known
 * @param lost how many are missing; null: not known
 */
public record EventGap(
        long number,
        Cause cause,
        @Nullable Instant from,
        Instant until,
        @Nullable Long lost) implements EventEntry {

    /** Causes of gaps that are stored. */
    @Stored(names = "NOT_WRITTEN SERVER_ENDED RESTORED")
    public enum Cause {
        /** The store took them not, or not soon enough. */
        NOT_WRITTEN,
        /** A process ended without storing what it had in memory. */
        SERVER_ENDED,
        /** The store was restored from a backup. */
        RESTORED
    }

    @Override
    public Instant at() {
        return until;
    }
}
