package org.dronemap.store.mongo;

import java.nio.charset.StandardCharsets;
import java.util.Date;
import java.util.UUID;
import org.bson.Document;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.history.HistoryEvent;
import org.dronemap.core.stored.StoredNames;

/** Converts drones' events to MongoDB documents and back; a batch that is written again gets the same ids. */
final class EventDocument {
    /** Orders what happened at one moment. */
    static final String ORDER = "order";

    private EventDocument() {}

    /** {@code number}: the how manieth of its kind it is in the batch. */
    static Document of(HistoryEvent event, int number, long order) {
        String name = event.drone() + "\n" + event.at() + "\n" + StoredNames.of(event.kind()) + "\n" + event.text()
                + "\n" + number;
        return new Document(
                        "_id",
                        UUID.nameUUIDFromBytes(name.getBytes(StandardCharsets.UTF_8))
                                .toString())
                .append(PointDocument.DRONE, event.drone().value())
                .append(PointDocument.AT, Date.from(event.at()))
                .append(PointDocument.MICROS, PointDocument.micros(event.at()))
                .append(ORDER, order)
                .append("kind", StoredNames.of(event.kind()))
                .append("text", event.text())
                .append("severity", event.severity() == null ? null : StoredNames.of(event.severity()))
                .append("by", event.by())
                .append("command", event.command())
                .append("result", event.result())
                .append("reason", event.reason());
    }

    static HistoryEvent read(Document document) {
        String severity = document.getString("severity");
        return new HistoryEvent(
                new DroneId(document.getString(PointDocument.DRONE)),
                PointDocument.time(document),
                StoredNames.constant(HistoryEvent.Kind.class, document.getString("kind")),
                document.getString("text"),
                severity == null ? null : StoredNames.constant(Severity.class, severity),
                document.getString("by"),
                document.getString("command"),
                document.getString("result"),
                document.getString("reason"));
    }
}
