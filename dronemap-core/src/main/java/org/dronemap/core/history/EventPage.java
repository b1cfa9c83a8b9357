package org.dronemap.core.history;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * A part of the numbered series of events.
 *
 * @param entries by their numbers
 * @param next the number to go on after: all up to it were looked at
 * @param more whether there are further entries
 */
public record EventPage(EventSeries series, List<EventEntry> entries, long next, boolean more) {
    public EventPage {
        entries = List.copyOf(entries);
    }

    /** Of the first events and the first gaps after a number, at most {@code limit} of each, those that come first. */
    public static EventPage of(
            EventSeries series, long after, int limit, List<NumberedEvent> events, List<EventGap> gaps) {
        List<EventEntry> all = new ArrayList<>(events);
        all.addAll(gaps);
        all.sort(Comparator.comparingLong(EventEntry::number));
        boolean full = all.size() >= limit;
        List<EventEntry> entries = full ? all.subList(0, limit) : all;
        long next = full ? entries.get(limit - 1).number() : Math.max(after, series.newest());
        return new EventPage(series, entries, next, full);
    }
}
