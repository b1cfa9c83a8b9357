package org.dronemap.store.mongo;

import com.mongodb.client.MongoCollection;
import com.mongodb.client.MongoDatabase;
import com.mongodb.client.model.CreateCollectionOptions;
import com.mongodb.client.model.IndexOptions;
import com.mongodb.client.model.Indexes;
import com.mongodb.client.model.TimeSeriesGranularity;
import com.mongodb.client.model.TimeSeriesOptions;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.bson.Document;
import org.dronemap.core.history.Retention;
import org.jspecify.annotations.Nullable;

/** The MongoDB collections that hold telemetry and drones' events, and how long their documents last. Thread-safe. */
final class MongoCollections {
    private static final String POINTS = "telemetry";
    private static final String THINNED = "telemetry_thinned";
    private static final String THINNED_DAYS = "telemetry_thinned_day";
    private static final String EVENTS = "drone_event";
    private static final String EVENT_GAPS = "event_gap";
    private static final String EVENT_SERIES = "event_series";
    private static final String EXPIRY = "expiry";
    /** Expiry must not overtake the thinning that reads what expires, should that have been held up. */
    private static final Duration MARGIN = Duration.ofDays(3);

    private final MongoDatabase database;

    // All guarded by this.
    private boolean made;
    private @Nullable Retention kept;

    MongoCollections(MongoDatabase database) {
        this.database = database;
    }

    MongoCollection<Document> points() {
        return database.getCollection(POINTS);
    }

    MongoCollection<Document> thinned() {
        return database.getCollection(THINNED);
    }

    /** Which days are only there thinned. */
    MongoCollection<Document> thinnedDays() {
        return database.getCollection(THINNED_DAYS);
    }

    MongoCollection<Document> events() {
        return database.getCollection(EVENTS);
    }

    /** Where some events are missing. */
    MongoCollection<Document> eventGaps() {
        return database.getCollection(EVENT_GAPS);
    }

    /** One document: what is known of the numbers of events. */
    MongoCollection<Document> eventSeries() {
        return database.getCollection(EVENT_SERIES);
    }

    /** Before anything is written: a collection that came about by itself would be none of time series. */
    synchronized void make() {
        if (made) {
            return;
        }
        List<String> known = database.listCollectionNames().into(new ArrayList<>());
        if (!known.contains(POINTS)) {
            database.createCollection(POINTS, timeSeries(TimeSeriesGranularity.SECONDS));
        }
        if (!known.contains(THINNED)) {
            database.createCollection(THINNED, timeSeries(TimeSeriesGranularity.MINUTES));
        }
        points().createIndex(Indexes.ascending(PointDocument.DRONE, PointDocument.AT));
        thinned().createIndex(Indexes.ascending(PointDocument.DRONE, PointDocument.AT));
        events().createIndex(Indexes.ascending(PointDocument.DRONE, PointDocument.AT));
        events().createIndex(Indexes.ascending(EventDocument.ORDER));
        made = true;
    }

    private static CreateCollectionOptions timeSeries(TimeSeriesGranularity granularity) {
        return new CreateCollectionOptions()
                .timeSeriesOptions(new TimeSeriesOptions(PointDocument.AT)
                        .metaField(PointDocument.DRONE)
                        .granularity(granularity));
    }

    synchronized void expire(Retention retention) {
        make();
        if (retention.equals(kept)) {
            return;
        }
        int pointDays = retention.fullDays() == 0 ? retention.keepDays() : retention.fullDays();
        expire(POINTS, pointDays);
        expire(THINNED, retention.keepDays());
        expireEvents(retention.keepDays());
        kept = retention;
    }

    private void expire(String collection, int days) {
        database.runCommand(
                new Document("collMod", collection).append("expireAfterSeconds", days == 0 ? "off" : seconds(days)));
    }

    private void expireEvents(int days) {
        boolean there = events().listIndexes().into(new ArrayList<>()).stream()
                .anyMatch(index -> EXPIRY.equals(index.getString("name")));
        if (there) {
            events().dropIndex(EXPIRY);
        }
        if (days > 0) {
            events().createIndex(
                            Indexes.ascending(PointDocument.AT),
                            new IndexOptions().name(EXPIRY).expireAfter(seconds(days), TimeUnit.SECONDS));
        }
    }

    private static long seconds(int days) {
        return Duration.ofDays(days).plus(MARGIN).toSeconds();
    }
}
