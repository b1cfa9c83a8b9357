package org.dronemap.store.postgres;

import static org.assertj.core.api.Assertions.assertThat;

import java.sql.Connection;
import java.sql.SQLException;
import java.sql.Statement;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.dronemap.core.history.EventEntry;
import org.dronemap.core.history.HistoryEvent;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.store.contract.NumberedEventsContract;
import org.junit.jupiter.api.Test;

class PostgresNumberedEventsTest extends NumberedEventsContract {
    @Override
    protected TelemetryStore emptyStore() {
        return SharedDatabase.empty().telemetry();
    }

    @Override
    protected TelemetryStore again() {
        return SharedDatabase.again().telemetry();
    }

    /** A transaction whose connection broke may end after the one that wrote the same once more. */
    @Test
    void showsNoLowerNumberAfterAHigherOne() throws SQLException {
        PostgresStores database = SharedDatabase.empty();
        try (Connection slow = database.dataSource().getConnection();
                Statement statement = slow.createStatement()) {
            slow.setAutoCommit(false);
            PostgresEventSeries.append(slow, List.of(mode("first")), null);
            CompletableFuture<Void> quick =
                    CompletableFuture.runAsync(() -> database.telemetry().append(List.of(), List.of(mode("second"))));
            await(statement, quick);
            List<EventEntry> meanwhile = database.telemetry().eventsAfter(0, 10).entries();
            slow.commit();
            quick.join();

            assertThat(meanwhile).isEmpty();
            assertThat(database.telemetry().eventsAfter(0, 10).entries()).hasSize(2);
        }
    }

    /** Until it is done, or waits for a lock. */
    private static void await(Statement statement, CompletableFuture<Void> work) throws SQLException {
        long until = System.nanoTime() + Duration.ofSeconds(30).toNanos();
        boolean waits = false;
        while (!waits && !work.isDone() && System.nanoTime() < until) {
            try (var result = statement.executeQuery("SELECT count(*) FROM pg_locks WHERE NOT granted")) {
                result.next();
                waits = result.getInt(1) > 0;
            }
        }
    }

    private static HistoryEvent mode(String text) {
        return HistoryEvent.of(DRONE, START, HistoryEvent.Kind.MODE, text);
    }
}
