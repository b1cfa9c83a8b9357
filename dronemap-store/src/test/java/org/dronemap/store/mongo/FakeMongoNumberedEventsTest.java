package org.dronemap.store.mongo;

import static org.assertj.core.api.Assertions.assertThat;

import com.mongodb.client.MongoClient;
import com.mongodb.client.MongoClients;
import com.mongodb.client.MongoCollection;
import com.mongodb.client.model.Filters;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.bson.Document;
import org.dronemap.core.history.EventPage;
import org.dronemap.core.history.HistoryEvent;
import org.dronemap.core.history.Retention;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.store.contract.NumberedEventsContract;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class FakeMongoNumberedEventsTest extends NumberedEventsContract {
    private static final Retention MONTH = new Retention(0, 30, Duration.ofSeconds(10));

    private final FakeMongoServer server = new FakeMongoServer();
    private final List<MongoTelemetryStore> opened = new ArrayList<>();

    @Override
    protected TelemetryStore emptyStore() {
        return again();
    }

    @Override
    protected TelemetryStore again() {
        MongoTelemetryStore store = MongoTelemetryStore.open(server.url() + "/telemetry");
        opened.add(store);
        return store;
    }

    @AfterEach
    void close() {
        opened.forEach(MongoTelemetryStore::close);
        server.close();
    }

    @Test
    void showsNothingOfABatchThatIsNotAllThere() {
        TelemetryStore store = again();
        store.append(List.of(), List.of(mode("all")));
        long newest = store.eventsAfter(0, 10).next();
        documents("drone_event", events -> events.insertOne(EventDocument.of(mode("half"), 1, newest + 2)));

        assertThat(store.eventsAfter(0, 10).entries()).hasSize(1);

        store.append(List.of(), List.of(mode("half"), mode("more")));
        EventPage page = store.eventsAfter(0, 10);
        assertThat(page.entries()).hasSize(3);
        assertThat(page.next()).isGreaterThan(newest + 1);
    }

    @Test
    void tellsThatMongoDeletedEventsWhileNoServerLooked() {
        TelemetryStore store = again();
        store.append(List.of(), List.of(mode("gone"), mode("gone, too"), mode("kept")));
        EventPage before = store.eventsAfter(0, 10);
        store.tidy(MONTH, START);
        documents("drone_event", events -> events.deleteMany(Filters.regex("text", "gone")));

        TelemetryStore later = again();
        later.tidy(MONTH, START.plusSeconds(60));

        EventPage after = later.eventsAfter(0, 10);
        assertThat(after.entries()).hasSize(1);
        assertThat(after.series().expired()).isEqualTo(before.entries().get(1).number());
    }

    private void documents(String collection, Consumer<MongoCollection<Document>> work) {
        try (MongoClient client = MongoClients.create(server.url())) {
            work.accept(client.getDatabase("telemetry").getCollection(collection));
        }
    }

    private static HistoryEvent mode(String text) {
        return HistoryEvent.of(DRONE, START, HistoryEvent.Kind.MODE, text);
    }
}
