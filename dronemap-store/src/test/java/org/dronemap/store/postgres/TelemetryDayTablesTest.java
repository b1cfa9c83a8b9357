package org.dronemap.store.postgres;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.sql.Connection;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.history.Retention;
import org.dronemap.core.history.TelemetryPoint;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.core.history.TimeRange;
import org.junit.jupiter.api.Test;

/** Days that are over are laid down by drone, and nothing of them gets lost. */
class TelemetryDayTablesTest {
    /** Tables of days outlive a test. */
    private static final AtomicInteger TESTS = new AtomicInteger();

    private static final Retention FOR_EVER = new Retention(0, 0, Duration.ofSeconds(10));
    private static final int DRONES = 3;

    private final PostgresStores database = SharedDatabase.empty();
    private final TelemetryStore store = database.telemetry();
    private final AtomicInteger brought = new AtomicInteger();
    private final LocalDate date = LocalDate.of(2025, 1, 1).plusDays(10L * TESTS.incrementAndGet());
    private final String table = "telemetry_" + date.toString().replace("-", "");
    private final Instant day = date.atStartOfDay(ZoneOffset.UTC).toInstant();
    private final Instant nextDay = day.plus(Duration.ofDays(1));

    TelemetryDayTablesTest() {
        store.tidy(FOR_EVER, day);
        bring(30);
    }

    @Test
    void liesByDroneAndTimeOnceItIsOver() throws SQLException {
        store.tidy(FOR_EVER, nextDay.plus(Duration.ofMinutes(61)));

        assertThat(tables()).contains(table + "_sorted").doesNotContain(table);
        assertThat(asItLies(table + "_sorted")).hasSize(30).isSorted();
        assertAllIsThere();
    }

    @Test
    void staysAsItWasWrittenWhileItsLastRowsMayCome() throws SQLException {
        store.tidy(FOR_EVER, nextDay.plus(Duration.ofMinutes(59)));

        assertThat(tables()).contains(table).doesNotContain(table + "_sorted");
        assertThat(asItLies(table))
                .extracting(row -> row.substring(0, 8))
                .startsWith("copter-0", "copter-1", "copter-2");
        assertAllIsThere();
    }

    @Test
    void takesRowsThatComeLater() {
        store.tidy(FOR_EVER, nextDay.plus(Duration.ofHours(2)));
        bring(30);
        store.tidy(FOR_EVER, nextDay.plus(Duration.ofHours(3)));

        assertAllIsThere();
    }

    @Test
    void losesNothingThatComesWhileItIsSorted() {
        AtomicBoolean enough = new AtomicBoolean();
        CompletableFuture<Void> late = CompletableFuture.runAsync(() -> {
            while (!enough.get()) {
                bring(DRONES);
            }
        });
        await().until(() -> brought.get() > 60);
        for (int hour = 2; hour < 22; hour++) {
            store.tidy(FOR_EVER, nextDay.plus(Duration.ofHours(hour)));
        }
        enough.set(true);
        late.join();

        assertAllIsThere();
    }

    @Test
    void isSortedAnewAfterAServerThatEndedInTheMiddle() throws SQLException {
        try (Connection connection = database.dataSource().getConnection();
                Statement statement = connection.createStatement()) {
            statement.execute("CREATE TABLE " + table + "_sorted (LIKE telemetry)");
            statement.execute("INSERT INTO " + table + "_sorted SELECT * FROM telemetry LIMIT 10");
        }

        store.tidy(FOR_EVER, nextDay.plus(Duration.ofHours(2)));

        assertThat(tables()).contains(table + "_sorted");
        assertAllIsThere();
    }

    @Test
    void isThinnedLater() throws SQLException {
        store.tidy(FOR_EVER, nextDay.plus(Duration.ofHours(2)));
        store.tidy(new Retention(1, 30, Duration.ofSeconds(10)), nextDay.plus(Duration.ofDays(2)));

        assertThat(tables()).contains(table + "_thin").doesNotContain(table + "_sorted");
    }

    /** Of one drone after the other, as they come from the air. */
    private void bring(int count) {
        List<TelemetryPoint> batch = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            int number = brought.getAndIncrement();
            batch.add(new TelemetryPoint(
                    drone(number % DRONES),
                    day.plusMillis(number / DRONES),
                    null,
                    null,
                    null,
                    null,
                    null,
                    LinkState.LIVE,
                    LinkQuality.UNKNOWN,
                    "AUTO",
                    true,
                    null,
                    number));
        }
        store.append(batch, List.of());
    }

    private static DroneId drone(int number) {
        return new DroneId("copter-" + number);
    }

    private void assertAllIsThere() {
        List<Integer> kept = new ArrayList<>();
        for (int i = 0; i < DRONES; i++) {
            store.points(drone(i), new TimeRange(day, nextDay), point -> kept.add(point.missionItem()));
        }
        assertThat(kept).doesNotHaveDuplicates().hasSize(brought.get());
    }

    private List<String> tables() throws SQLException {
        return strings("SELECT inhrelid::regclass::text FROM pg_inherits WHERE inhparent = 'telemetry'::regclass");
    }

    private List<String> asItLies(String table) throws SQLException {
        return strings("SELECT drone_id || to_char(at, ' HH24:MI:SS.US') FROM " + table + " ORDER BY ctid");
    }

    private List<String> strings(String sql) throws SQLException {
        List<String> found = new ArrayList<>();
        try (Connection connection = database.dataSource().getConnection();
                Statement statement = connection.createStatement();
                ResultSet result = statement.executeQuery(sql)) {
            while (result.next()) {
                found.add(result.getString(1));
            }
        }
        return found;
    }
}
