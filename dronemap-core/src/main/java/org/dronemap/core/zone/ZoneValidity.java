package org.dronemap.core.zone;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/** Period in which a zone is in force; null: unbounded on that side. */
public record ZoneValidity(@Nullable Instant from, @Nullable Instant until) {
    public static final ZoneValidity ALWAYS = new ZoneValidity(null, null);

    public ZoneValidity {
        if (from != null && until != null && !from.isBefore(until)) {
            throw new IllegalArgumentException("the end of the validity must be after its beginning");
        }
    }

    public boolean at(Instant moment) {
        return between(moment, moment);
    }

    /** At any time of a span. */
    public boolean between(Instant begin, Instant end) {
        return (from == null || !from.isAfter(end)) && (until == null || until.isAfter(begin));
    }
}
