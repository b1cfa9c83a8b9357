package org.dronemap.store.mongo;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Date;
import java.util.List;
import java.util.Objects;
import org.bson.Document;
import org.bson.conversions.Bson;
import org.dronemap.core.history.SeriesQuery;
import org.dronemap.core.history.SeriesSlot;
import org.dronemap.core.history.TelemetryField;
import org.dronemap.core.history.TimeRange;
import org.jspecify.annotations.Nullable;

/** Builds the MongoDB aggregation that reduces telemetry points to a series of time slots. */
final class SeriesPipeline {
    private static final String OFFSET = "offset";

    private final SeriesQuery query;
    private final Instant from;
    private final long slotMicros;

    SeriesPipeline(SeriesQuery query) {
        this.query = query;
        this.from = query.span().from();
        this.slotMicros = query.slot().toNanos() / 1_000;
    }

    /** For a part of the span that lies in one collection. */
    List<Bson> stages(TimeRange part) {
        Document within = new Document("$gte", Date.from(part.from())).append("$lte", Date.from(part.until()));
        Document micros = new Document(
                "$add",
                List.of(
                        new Document(
                                "$multiply",
                                List.of(
                                        new Document("$subtract", List.of("$" + PointDocument.AT, Date.from(from))),
                                        1_000L)),
                        new Document("$subtract", List.of("$" + PointDocument.MICROS, PointDocument.micros(from)))));
        Document fields = new Document(OFFSET, micros);
        Document group = new Document(
                        "_id", new Document("$floor", new Document("$divide", List.of("$" + OFFSET, slotMicros))))
                .append(OFFSET, new Document("$min", "$" + OFFSET));
        for (TelemetryField field : query.fields()) {
            String member = PointDocument.member(field);
            fields.append(member, 1);
            group.append("least_" + member, new Document("$min", "$" + member));
            group.append("most_" + member, new Document("$max", "$" + member));
        }
        return List.of(
                new Document(
                        "$match",
                        new Document(PointDocument.DRONE, query.drone().value()).append(PointDocument.AT, within)),
                new Document("$project", fields),
                new Document(
                        "$match",
                        new Document(
                                OFFSET, new Document("$gte", micros(part.from())).append("$lt", micros(part.until())))),
                new Document("$group", group),
                new Document("$sort", new Document(OFFSET, 1)));
    }

    private long micros(Instant time) {
        // A time between two microseconds is after the one that it is cut to.
        return (Duration.between(from, time).toNanos() + 999) / 1_000;
    }

    SeriesSlot slot(Document group) {
        long offset = ((Number) Objects.requireNonNull(group.get(OFFSET))).longValue();
        List<SeriesSlot.@Nullable Extent> extents = new ArrayList<>();
        for (TelemetryField field : query.fields()) {
            Double least = PointDocument.number(group.get("least_" + PointDocument.member(field)));
            Double most = PointDocument.number(group.get("most_" + PointDocument.member(field)));
            extents.add(least == null || most == null ? null : new SeriesSlot.Extent(least, most));
        }
        return new SeriesSlot(from.plusNanos(offset * 1_000), extents);
    }
}
