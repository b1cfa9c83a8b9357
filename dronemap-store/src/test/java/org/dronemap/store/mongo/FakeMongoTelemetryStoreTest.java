package org.dronemap.store.mongo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.List;
import org.dronemap.core.history.HistoryEvent;
import org.dronemap.core.history.Retention;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.core.history.TimeRange;
import org.dronemap.store.StoreException;
import org.dronemap.store.contract.TelemetryStoreContract;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** The adapter against a stand-in: what it keeps, and what it asks for that the stand-in does not know. */
class FakeMongoTelemetryStoreTest extends TelemetryStoreContract {
    private final FakeMongoServer server = new FakeMongoServer();
    private final MongoTelemetryStore adapter = MongoTelemetryStore.open(server.url() + "/telemetry");

    @Override
    protected TelemetryStore emptyStore() {
        return adapter;
    }

    @AfterEach
    void close() {
        adapter.close();
        server.close();
    }

    @Test
    void asksForTimeSeriesByDroneBeforeAnythingIsWritten() {
        assertThat(server.commands("create").toString())
                .contains("\"create\" : \"telemetry\"")
                .contains("\"create\" : \"telemetry_thinned\"")
                .contains("\"timeField\" : \"at\"")
                .contains("\"metaField\" : \"drone\"")
                .contains("\"granularity\" : \"seconds\"");
        assertThat(server.commands("insert"))
                .extracting(command -> command.get("insert"))
                .containsExactly("event_series");
    }

    @Test
    void asksForIndexesByDroneAndTime() {
        assertThat(server.commands("createIndexes"))
                .extracting(command -> command.get("createIndexes"))
                .containsExactly("telemetry", "telemetry_thinned", "drone_event", "drone_event");
        assertThat(server.commands("createIndexes").toString())
                .contains("\"key\" : { \"drone\" : 1, \"at\" : 1 }")
                .contains("\"key\" : { \"order\" : 1 }");
    }

    @Test
    void asksForExpiryOfEachCollectionAndAgainOnlyWhenItChanges() {
        int before = server.commands("collMod").size();
        Retention month = new Retention(7, 30, Duration.ofSeconds(10));

        adapter.tidy(month, START);
        adapter.tidy(month, START.plusSeconds(3_600));

        assertThat(server.commands("collMod")).hasSize(before + 2);
        assertThat(server.commands("collMod").subList(before, before + 2))
                .extracting(command ->
                        command.get("collMod") + " " + ((Number) command.get("expireAfterSeconds")).longValue())
                .containsExactly("telemetry " + 10 * 86_400, "telemetry_thinned " + 33 * 86_400);
        assertThat(server.commands("createIndexes").toString()).contains("\"expireAfterSeconds\" : " + 33 * 86_400);
    }

    @Test
    void asksForNoExpiryOfWhatIsKeptForEver() {
        assertThat(server.commands("collMod"))
                .extracting(command -> command.get("expireAfterSeconds"))
                .containsExactly("off", "off");
    }

    @Test
    void asksForWritesThatSurviveACrash() {
        adapter.append(List.of(), List.of(HistoryEvent.of(DRONE, START, HistoryEvent.Kind.MODE, "AUTO")));

        assertThat(server.commands("insert").toString())
                .contains("\"w\" : \"majority\"")
                .contains("\"j\" : true");
    }

    @Test
    void writesEventsOnceThoughTheBatchIsTriedAgain() {
        List<HistoryEvent> batch = List.of(
                HistoryEvent.of(DRONE, START, HistoryEvent.Kind.MESSAGE, "twice"),
                HistoryEvent.of(DRONE, START, HistoryEvent.Kind.MESSAGE, "twice"));
        adapter.append(List.of(), batch);
        adapter.append(List.of(), batch);

        assertThat(server.commands("insert"))
                .filteredOn(command -> "drone_event".equals(command.get("insert")))
                .hasSize(2);
        assertThat(adapter.events(DRONE, new TimeRange(START, START.plusSeconds(1)), 10))
                .isEqualTo(batch);
    }

    @Test
    void saysThatTheServerIsAwayAndNeverRepeatsThePassword() {
        server.close();

        assertThatThrownBy(() -> adapter.tidy(Retention.DEFAULT, START))
                .isInstanceOfSatisfying(
                        StoreException.class,
                        away -> assertThat(away.isTransient()).isTrue())
                .hasMessageContaining("MongoDB");
        assertThatThrownBy(() -> MongoTelemetryStore.open("http://user:secret@host"))
                .isInstanceOf(StoreException.class)
                .message()
                .doesNotContain("secret");
    }
}
