package org.dronemap.store.memory;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import java.util.stream.Stream;
import org.dronemap.core.history.EventEntry;
import org.dronemap.core.history.EventGap;
import org.dronemap.core.history.EventLoss;
import org.dronemap.core.history.EventPage;
import org.dronemap.core.history.EventSeries;
import org.dronemap.core.history.HistoryEvent;
import org.dronemap.core.history.NumberedEvent;
import org.dronemap.store.StoredInstant;
import org.jspecify.annotations.Nullable;

/** The numbered events of a {@link MemoryTelemetryStore}, which guards it. */
final class MemoryEventSeries {
    private final String id = UUID.randomUUID().toString();
    private final List<EventEntry> entries = new ArrayList<>();
    private long newest;
    private long expired;
    private @Nullable Instant expiredBefore;
    private @Nullable Instant openedAt;

    void append(List<HistoryEvent> events, @Nullable EventLoss lost) {
        if (lost != null) {
            entries.add(new EventGap(
                    ++newest,
                    EventGap.Cause.NOT_WRITTEN,
                    StoredInstant.of(lost.from()),
                    StoredInstant.of(lost.until()),
                    lost.count()));
        }
        for (HistoryEvent event : events) {
            entries.add(new NumberedEvent(++newest, event));
        }
    }

    /** In the order of their numbers. */
    Stream<HistoryEvent> all() {
        return numbered().map(NumberedEvent::event);
    }

    private Stream<NumberedEvent> numbered() {
        return entries.stream().filter(NumberedEvent.class::isInstance).map(NumberedEvent.class::cast);
    }

    void open(Instant now) {
        newest = Math.max(newest, now.toEpochMilli() * 1_000);
        if (openedAt != null) {
            Instant last =
                    all().reduce((before, after) -> after).map(HistoryEvent::at).orElse(openedAt);
            Instant from = last.isAfter(openedAt) ? last : openedAt;
            entries.add(
                    new EventGap(++newest, EventGap.Cause.SERVER_ENDED, from.isBefore(now) ? from : now, now, null));
        }
        openedAt = now;
    }

    void close() {
        openedAt = null;
    }

    EventPage after(long number, int limit) {
        List<EventGap> gaps = entries.stream()
                .filter(EventGap.class::isInstance)
                .map(EventGap.class::cast)
                .filter(gap -> gap.number() > number)
                .limit(limit)
                .toList();
        List<NumberedEvent> events =
                numbered().filter(event -> event.number() > number).limit(limit).toList();
        return EventPage.of(new EventSeries(id, newest, expired, expiredBefore), number, limit, events, gaps);
    }

    void drop(Instant kept) {
        long highest = entries.stream()
                .filter(entry -> entry.at().isBefore(kept))
                .mapToLong(EventEntry::number)
                .max()
                .orElse(0);
        if (entries.removeIf(entry -> entry.at().isBefore(kept))) {
            expired = Math.max(expired, highest);
            expiredBefore = kept;
        }
    }
}
