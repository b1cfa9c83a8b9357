package org.dronemap.store.mongo;

import com.mongodb.client.model.Filters;
import com.mongodb.client.model.Sorts;
import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.Date;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.bson.Document;
import org.bson.conversions.Bson;
import org.dronemap.core.history.Retention;
import org.dronemap.core.history.TelemetryDownsampler;
import org.dronemap.core.history.TelemetryPoint;
import org.dronemap.core.history.TimeRange;
import org.jspecify.annotations.Nullable;

/** Thins days of telemetry in MongoDB, and knows of which days only the thinned points are read. */
final class ThinnedDays {
    private static final int AT_ONCE = 5_000;

    private final MongoCollections collections;

    /** A stretch of time whose points all lie in one collection. */
    record DayRange(TimeRange span, boolean thinned) {}

    ThinnedDays(MongoCollections collections) {
        this.collections = collections;
    }

    /** In the order of time. */
    List<DayRange> parts(TimeRange span) {
        Set<LocalDate> thinned = in(span);
        List<DayRange> parts = new ArrayList<>();
        Instant from = span.from();
        for (LocalDate day : thinned) {
            Instant begin = later(begin(day), from);
            Instant end = earlier(begin(day.plusDays(1)), span.until());
            if (from.isBefore(begin)) {
                parts.add(new DayRange(new TimeRange(from, begin), false));
            }
            if (begin.isBefore(end)) {
                parts.add(new DayRange(new TimeRange(begin, end), true));
            }
            from = later(from, end);
        }
        if (from.isBefore(span.until())) {
            parts.add(new DayRange(new TimeRange(from, span.until()), false));
        }
        return parts;
    }

    private Set<LocalDate> in(TimeRange span) {
        Bson within = Filters.and(
                Filters.gte("_id", day(span.from()).toString()),
                Filters.lte("_id", day(span.until()).toString()));
        Set<LocalDate> days = new TreeSet<>();
        collections
                .thinnedDays()
                .find(within)
                .forEach(document -> days.add(LocalDate.parse(document.getString("_id"))));
        return days;
    }

    /** Each day before that one which was not thinned before. */
    void thin(Retention retention, @Nullable LocalDate firstFull) {
        Document oldest = collections
                .points()
                .find()
                .sort(Sorts.ascending(PointDocument.AT))
                .limit(1)
                .first();
        if (oldest == null || firstFull == null) {
            return;
        }
        LocalDate first = day(PointDocument.time(oldest));
        Set<LocalDate> done = in(new TimeRange(begin(first), later(begin(first), begin(firstFull))));
        for (LocalDate day = first; day.isBefore(firstFull); day = day.plusDays(1)) {
            if (!done.contains(day)) {
                thin(day, retention);
            }
        }
    }

    /** A try that broke off may leave points behind; those of one moment are read once. */
    private void thin(LocalDate day, Retention retention) {
        Bson within = Filters.and(
                Filters.gte(PointDocument.AT, Date.from(begin(day))),
                Filters.lt(PointDocument.AT, Date.from(begin(day.plusDays(1)))));
        List<Document> kept = new ArrayList<>();
        TelemetryDownsampler thinning =
                new TelemetryDownsampler(retention.thinned(), point -> kept.add(PointDocument.of(point)));
        collections
                .points()
                .find(within)
                .sort(Sorts.ascending(PointDocument.DRONE, PointDocument.AT, PointDocument.MICROS))
                .allowDiskUse(true)
                .batchSize(AT_ONCE)
                .forEach(document -> {
                    TelemetryPoint point = PointDocument.read(document);
                    thinning.add(point);
                    if (kept.size() >= AT_ONCE) {
                        collections.thinned().insertMany(kept);
                        kept.clear();
                    }
                });
        thinning.finish();
        if (!kept.isEmpty()) {
            collections.thinned().insertMany(kept);
        }
        collections.thinnedDays().insertOne(new Document("_id", day.toString()));
    }

    private static LocalDate day(Instant time) {
        return LocalDate.ofInstant(time, ZoneOffset.UTC);
    }

    private static Instant begin(LocalDate day) {
        return day.atStartOfDay(ZoneOffset.UTC).toInstant();
    }

    private static Instant later(Instant one, Instant other) {
        return one.isAfter(other) ? one : other;
    }

    private static Instant earlier(Instant one, Instant other) {
        return one.isBefore(other) ? one : other;
    }
}
