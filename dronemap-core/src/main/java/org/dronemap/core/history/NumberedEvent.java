package org.dronemap.core.history;

import java.time.Instant;

/** An event with its number in the series of its store. */
public record NumberedEvent(long number, HistoryEvent event) implements EventEntry {
    @Override
    public Instant at() {
        return event.at();
    }
}
