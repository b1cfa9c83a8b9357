package org.dronemap.store.mongo;

import com.mongodb.ConnectionString;
import com.mongodb.MongoClientSettings;
import com.mongodb.MongoException;
import com.mongodb.MongoNotPrimaryException;
import com.mongodb.MongoSocketException;
import com.mongodb.MongoTimeoutException;
import com.mongodb.WriteConcern;
import com.mongodb.client.MongoClient;
import com.mongodb.client.MongoClients;
import com.mongodb.client.MongoCollection;
import com.mongodb.client.MongoDatabase;
import com.mongodb.client.model.Filters;
import com.mongodb.client.model.InsertManyOptions;
import com.mongodb.client.model.Sorts;
import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.Date;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.bson.Document;
import org.bson.conversions.Bson;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.history.EventLoss;
import org.dronemap.core.history.EventPage;
import org.dronemap.core.history.HistoryEvent;
import org.dronemap.core.history.Retention;
import org.dronemap.core.history.SeriesQuery;
import org.dronemap.core.history.SeriesSlot;
import org.dronemap.core.history.TelemetryPoint;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.core.history.TimeRange;
import org.dronemap.store.StoreException;
import org.dronemap.store.StoredInstant;
import org.jspecify.annotations.Nullable;

/** Stores telemetry in MongoDB; old days are hidden at once, and deleted later by MongoDB. Thread-safe. */
public final class MongoTelemetryStore implements TelemetryStore, AutoCloseable {
    private static final String USUAL_DATABASE = "dronemap";
    private static final int PATIENCE_SECONDS = 5;
    private static final int LONGEST_ANSWER_SECONDS = 60;
    private static final InsertManyOptions ANY_ORDER = new InsertManyOptions().ordered(false);

    private final MongoClient client;
    private final MongoDatabase database;
    private final MongoCollections collections;
    private final ThinnedDays thinned;
    private final MongoEventSeries series;
    private volatile Instant firstKept = Instant.EPOCH;

    private MongoTelemetryStore(MongoClient client, String database) {
        this.client = client;
        this.database = client.getDatabase(database).withWriteConcern(WriteConcern.MAJORITY.withJournal(true));
        this.collections = new MongoCollections(this.database);
        this.thinned = new ThinnedDays(collections);
        this.series = new MongoEventSeries(collections);
    }

    /**
     * {@code url} such as {@code mongodb://user:password@host:27017/dronemap}; does not connect yet. The sentence of a
     * refusal never repeats it, for it may hold a password.
     */
    public static MongoTelemetryStore open(String url) {
        return open(url, MongoClientSettings.builder());
    }

    static MongoTelemetryStore open(String url, MongoClientSettings.Builder settings) {
        try {
            ConnectionString parsed = new ConnectionString(url.strip());
            MongoClientSettings made = settings.applyConnectionString(parsed)
                    .applicationName("dronemap")
                    .applyToClusterSettings(
                            cluster -> cluster.serverSelectionTimeout(PATIENCE_SECONDS, TimeUnit.SECONDS))
                    .applyToSocketSettings(socket -> socket.connectTimeout(PATIENCE_SECONDS, TimeUnit.SECONDS)
                            .readTimeout(LONGEST_ANSWER_SECONDS, TimeUnit.SECONDS))
                    .build();
            String name = parsed.getDatabase();
            return new MongoTelemetryStore(MongoClients.create(made), name == null ? USUAL_DATABASE : name);
        } catch (IllegalArgumentException e) {
            throw new StoreException(
                    "The address of the MongoDB is not of the form mongodb://user:password@host:27017/name.");
        }
    }

    @Override
    public void append(List<TelemetryPoint> points, List<HistoryEvent> events, @Nullable EventLoss lost) {
        trying(() -> {
            collections.make();
            if (!points.isEmpty()) {
                collections
                        .points()
                        .insertMany(points.stream().map(PointDocument::of).toList(), ANY_ORDER);
            }
            series.append(events, lost);
            return true;
        });
    }

    @Override
    public void openEvents(Instant now) {
        trying(() -> {
            collections.make();
            series.open(now);
            return true;
        });
    }

    @Override
    public void closeEvents() {
        trying(() -> {
            series.close();
            return true;
        });
    }

    @Override
    public EventPage eventsAfter(long number, int limit) {
        return trying(() -> series.after(number, limit));
    }

    @Override
    public void points(DroneId drone, TimeRange span, Consumer<TelemetryPoint> each) {
        trying(() -> {
            Instant[] before = {Instant.MIN};
            for (ThinnedDays.DayRange part : thinned.parts(kept(span))) {
                in(part).find(within(drone, part.span()))
                        .sort(Sorts.ascending(PointDocument.AT, PointDocument.MICROS))
                        .allowDiskUse(true)
                        .forEach(document -> {
                            TelemetryPoint point = PointDocument.read(document);
                            if (part.span().contains(point.at()) && point.at().isAfter(before[0])) {
                                before[0] = point.at();
                                each.accept(point);
                            }
                        });
            }
            return true;
        });
    }

    @Override
    public List<SeriesSlot> series(SeriesQuery query) {
        return trying(() -> {
            SeriesPipeline pipeline = new SeriesPipeline(query);
            List<SeriesSlot> slots = new ArrayList<>();
            for (ThinnedDays.DayRange part : thinned.parts(kept(query.span()))) {
                in(part).aggregate(pipeline.stages(part.span())).forEach(group -> slots.add(pipeline.slot(group)));
            }
            return List.copyOf(slots);
        });
    }

    @Override
    public List<HistoryEvent> events(DroneId drone, TimeRange span, int limit) {
        return trying(() -> {
            TimeRange kept = kept(span);
            List<HistoryEvent> events = new ArrayList<>();
            for (Document document : collections
                    .events()
                    .find(within(drone, kept))
                    .sort(Sorts.ascending(PointDocument.AT, PointDocument.MICROS, EventDocument.ORDER))) {
                HistoryEvent event = EventDocument.read(document);
                if (kept.contains(event.at())) {
                    events.add(event);
                }
                if (events.size() == limit) {
                    break;
                }
            }
            return List.copyOf(events);
        });
    }

    @Override
    public void tidy(Retention retention, Instant now) {
        trying(() -> {
            collections.expire(retention);
            LocalDate kept = retention.firstKept(now);
            firstKept = kept == null
                    ? Instant.EPOCH
                    : kept.atStartOfDay(ZoneOffset.UTC).toInstant();
            series.expire(kept == null ? null : firstKept);
            thinned.thin(retention, retention.firstFull(now));
            return true;
        });
    }

    @Override
    public String server() {
        return trying(() ->
                "MongoDB " + database.runCommand(new Document("buildInfo", 1)).getString("version"));
    }

    private MongoCollection<Document> in(ThinnedDays.DayRange part) {
        return part.thinned() ? collections.thinned() : collections.points();
    }

    /** The server knows milliseconds only: what is too much at the edges is left out here. */
    private static Bson within(DroneId drone, TimeRange span) {
        return Filters.and(
                Filters.eq(PointDocument.DRONE, drone.value()),
                Filters.gte(PointDocument.AT, Date.from(span.from())),
                Filters.lte(PointDocument.AT, Date.from(span.until())));
    }

    private TimeRange kept(TimeRange span) {
        Instant from = StoredInstant.of(span.from().plusNanos(999));
        Instant until = StoredInstant.of(span.until().plusNanos(999));
        Instant first = from.isBefore(firstKept) ? firstKept : from;
        return new TimeRange(first, until.isBefore(first) ? first : until);
    }

    private static <T> T trying(Supplier<T> work) {
        try {
            return work.get();
        } catch (MongoTimeoutException | MongoSocketException | MongoNotPrimaryException e) {
            throw StoreException.passing("The MongoDB for telemetry cannot be reached: " + e.getMessage(), e);
        } catch (MongoException e) {
            throw new StoreException("The MongoDB for telemetry refused: " + e.getMessage(), e);
        }
    }

    @Override
    public void close() {
        client.close();
    }
}
