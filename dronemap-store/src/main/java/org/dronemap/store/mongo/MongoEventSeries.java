package org.dronemap.store.mongo;

import com.mongodb.ErrorCategory;
import com.mongodb.MongoBulkWriteException;
import com.mongodb.bulk.BulkWriteError;
import com.mongodb.client.model.Filters;
import com.mongodb.client.model.InsertManyOptions;
import com.mongodb.client.model.Sorts;
import com.mongodb.client.model.Updates;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Date;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.UUID;
import org.bson.Document;
import org.bson.conversions.Bson;
import org.dronemap.core.history.EventGap;
import org.dronemap.core.history.EventLoss;
import org.dronemap.core.history.EventPage;
import org.dronemap.core.history.EventSeries;
import org.dronemap.core.history.HistoryEvent;
import org.dronemap.core.history.NumberedEvent;
import org.jspecify.annotations.Nullable;

/**
 * Numbers drones' events in MongoDB, and reads them by their numbers. Documents come to be seen in any order: readers go
 * no further than the number that is noted when all of a batch are there. Thread-safe.
 */
final class MongoEventSeries {
    private static final InsertManyOptions ANY_ORDER = new InsertManyOptions().ordered(false);
    private static final Bson SERIES = Filters.eq("_id", "series");
    private static final String ID = "id";
    private static final String NEWEST = "newest";
    private static final String OPENED = "opened";
    private static final String EXPIRED = "expired";
    private static final String EXPIRED_BEFORE = "expiredBefore";
    private static final String FIRST = "first";
    private static final long GREATEST_FLOOR = 1L << 52;

    private final MongoCollections collections;

    /** Guarded by this; 0: not known yet. */
    private long given;

    MongoEventSeries(MongoCollections collections) {
        this.collections = collections;
    }

    synchronized void append(List<HistoryEvent> events, @Nullable EventLoss lost) {
        if (events.isEmpty() && lost == null) {
            return;
        }
        begin();
        if (lost != null) {
            insert(new EventGap(++given, EventGap.Cause.NOT_WRITTEN, lost.from(), lost.until(), lost.count()));
        }
        if (!events.isEmpty()) {
            insert(events);
        }
        // All that is there up to it can be seen from now on.
        change(Updates.max(NEWEST, given));
    }

    private void insert(EventGap gap) {
        collections.eventGaps().insertOne(EventGapDocument.of(gap));
    }

    private void insert(List<HistoryEvent> events) {
        Map<HistoryEvent, Integer> counts = new HashMap<>();
        List<Document> documents = events.stream()
                .map(event -> EventDocument.of(event, counts.merge(event, 1, Integer::sum), ++given))
                .toList();
        try {
            collections.events().insertMany(documents, ANY_ORDER);
        } catch (MongoBulkWriteException e) {
            boolean allKnown = e.getWriteErrors().stream().allMatch(MongoEventSeries::isKnown);
            if (!allKnown || e.getWriteConcernError() != null) {
                throw e;
            }
        }
    }

    /** It was written before by a try that seemed to fail. */
    private static boolean isKnown(BulkWriteError error) {
        return error.getCategory() == ErrorCategory.DUPLICATE_KEY;
    }

    synchronized void open(Instant now) {
        Document state = begin();
        given = Math.max(given, Math.min(now.toEpochMilli() * 1_000, GREATEST_FLOOR));
        Instant before = EventGapDocument.timeOrNull(state.getLong(OPENED));
        if (before != null) {
            Document last = collections
                    .events()
                    .find()
                    .sort(Sorts.descending(EventDocument.ORDER))
                    .first();
            Instant stored = last == null ? before : PointDocument.time(last);
            Instant from = stored.isAfter(before) ? stored : before;
            insert(new EventGap(++given, EventGap.Cause.SERVER_ENDED, from.isBefore(now) ? from : now, now, null));
        }
        change(Updates.combine(Updates.max(NEWEST, given), Updates.set(OPENED, EventGapDocument.micros(now))));
    }

    synchronized void close() {
        change(Updates.set(OPENED, null));
    }

    EventPage after(long number, int limit) {
        Document state = state();
        if (state == null) {
            state = begin();
        }
        EventSeries series = series(state);
        Bson shown =
                Filters.and(Filters.gt(EventDocument.ORDER, number), Filters.lte(EventDocument.ORDER, series.newest()));
        Instant kept = series.expiredBefore();
        if (kept != null) {
            // Those are there until MongoDB deletes them.
            shown = Filters.and(shown, Filters.gte(PointDocument.AT, Date.from(kept)));
        }
        List<NumberedEvent> events = collections
                .events()
                .find(shown)
                .sort(Sorts.ascending(EventDocument.ORDER))
                .limit(limit)
                .map(document -> new NumberedEvent(document.getLong(EventDocument.ORDER), EventDocument.read(document)))
                .into(new ArrayList<>());
        List<EventGap> gaps = collections
                .eventGaps()
                .find(Filters.and(
                        Filters.gt(EventGapDocument.NUMBER, number),
                        Filters.lte(EventGapDocument.NUMBER, series.newest())))
                .sort(Sorts.ascending(EventGapDocument.NUMBER))
                .limit(limit)
                .map(EventGapDocument::read)
                .into(new ArrayList<>());
        return EventPage.of(series, number, limit, events, gaps);
    }

    /** What is older is not shown any more; events are deleted by MongoDB later, gaps now. */
    synchronized void expire(@Nullable Instant kept) {
        Document state = begin();
        long expired = Objects.requireNonNullElse(state.getLong(EXPIRED), 0L);
        if (kept != null) {
            Bson old = Filters.lt(EventGapDocument.UNTIL, EventGapDocument.micros(kept));
            Document gap = collections
                    .eventGaps()
                    .find(old)
                    .sort(Sorts.descending(EventGapDocument.NUMBER))
                    .first();
            long highest = Math.max(
                    newestBefore(kept), gap == null ? 0 : Objects.requireNonNull(gap.getLong(EventGapDocument.NUMBER)));
            expired = Math.max(expired, highest);
            if (highest > 0) {
                change(Updates.combine(
                        Updates.set(EXPIRED, expired), Updates.set(EXPIRED_BEFORE, EventGapDocument.micros(kept))));
            }
            collections.eventGaps().deleteMany(old);
        }
        noteDeleted(state, expired, kept);
    }

    private long newestBefore(Instant kept) {
        Document found = collections
                .events()
                .aggregate(List.of(
                        new Document("$match", new Document(PointDocument.AT, new Document("$lt", Date.from(kept)))),
                        new Document(
                                "$group",
                                new Document("_id", null)
                                        .append("highest", new Document("$max", "$" + EventDocument.ORDER)))))
                .first();
        return found == null ? 0 : Objects.requireNonNullElse(found.getLong("highest"), 0L);
    }

    /** MongoDB deletes by the time alone, also while no server looks: the first one that was there before tells. */
    private void noteDeleted(Document state, long expired, @Nullable Instant kept) {
        Document first = collections
                .events()
                .find(Filters.gt(EventDocument.ORDER, expired))
                .sort(Sorts.ascending(EventDocument.ORDER))
                .first();
        Long before = state.getLong(FIRST);
        Long now = first == null ? null : first.getLong(EventDocument.ORDER);
        if (kept != null && before != null && before > expired && !before.equals(now)) {
            long highest =
                    now == null ? Math.max(before, Objects.requireNonNullElse(state.getLong(NEWEST), 0L)) : now - 1;
            change(Updates.combine(
                    Updates.set(EXPIRED, highest), Updates.set(EXPIRED_BEFORE, EventGapDocument.micros(kept))));
        }
        change(Updates.set(FIRST, now));
    }

    private @Nullable Document state() {
        return collections.eventSeries().find(SERIES).first();
    }

    /** Numbers go on after all that are there. */
    private synchronized Document begin() {
        Document known = state();
        if (known != null && given > 0) {
            return known;
        }
        Document last = collections
                .events()
                .find()
                .sort(Sorts.descending(EventDocument.ORDER))
                .first();
        long highest = last == null ? 0 : Objects.requireNonNull(last.getLong(EventDocument.ORDER));
        Document state = known == null
                ? new Document("_id", "series")
                        .append(ID, UUID.randomUUID().toString())
                        .append(NEWEST, highest)
                : known;
        if (known == null) {
            collections.eventSeries().insertOne(state);
        }
        given = Math.max(highest, Objects.requireNonNullElse(state.getLong(NEWEST), 0L));
        return state;
    }

    private void change(Bson update) {
        collections.eventSeries().updateOne(SERIES, update);
    }

    private static EventSeries series(Document state) {
        return new EventSeries(
                state.getString(ID),
                Objects.requireNonNullElse(state.getLong(NEWEST), 0L),
                Objects.requireNonNullElse(state.getLong(EXPIRED), 0L),
                EventGapDocument.timeOrNull(state.getLong(EXPIRED_BEFORE)));
    }
}
