package org.dronemap.core.history;

import java.time.Instant;

/**
 * Events that could not be stored.
 *
 * @param from when the first of them happened
 * @param until when the last of them happened
 * @param count at least 1
 */
public record EventLoss(Instant from, Instant until, long count) {
    static EventLoss of(HistoryEvent event) {
        return new EventLoss(event.at(), event.at(), 1);
    }

    EventLoss plus(EventLoss other) {
        return new EventLoss(
                from.isBefore(other.from) ? from : other.from,
                until.isAfter(other.until) ? until : other.until,
                count + other.count);
    }
}
