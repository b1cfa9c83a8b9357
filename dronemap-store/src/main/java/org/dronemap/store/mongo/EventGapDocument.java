package org.dronemap.store.mongo;

import java.time.Instant;
import java.time.temporal.ChronoUnit;
import org.bson.Document;
import org.dronemap.core.history.EventGap;
import org.dronemap.core.stored.StoredNames;
import org.jspecify.annotations.Nullable;

/** Converts gaps among drones' events to MongoDB documents and back; times are microseconds since 1970. */
final class EventGapDocument {
    static final String NUMBER = "_id";
    static final String UNTIL = "until";

    private EventGapDocument() {}

    static Document of(EventGap gap) {
        return new Document(NUMBER, gap.number())
                .append("cause", StoredNames.of(gap.cause()))
                .append("from", gap.from() == null ? null : micros(gap.from()))
                .append(UNTIL, micros(gap.until()))
                .append("lost", gap.lost());
    }

    static EventGap read(Document document) {
        Long from = document.getLong("from");
        return new EventGap(
                document.getLong(NUMBER),
                StoredNames.constant(EventGap.Cause.class, document.getString("cause")),
                from == null ? null : time(from),
                time(document.getLong(UNTIL)),
                document.getLong("lost"));
    }

    static long micros(Instant time) {
        return ChronoUnit.MICROS.between(Instant.EPOCH, time);
    }

    static Instant time(long micros) {
        return Instant.EPOCH.plus(micros, ChronoUnit.MICROS);
    }

    static @Nullable Instant timeOrNull(@Nullable Long micros) {
        return micros == null ? null : time(micros);
    }
}
