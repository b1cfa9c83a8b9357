package org.dronemap.store.postgres;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.sql.Connection;
import java.sql.SQLException;
import java.sql.Statement;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.history.HistoryHealth;
import org.dronemap.core.history.TelemetryPoint;
import org.dronemap.core.history.TelemetryWriter;
import org.dronemap.core.history.TimeRange;
import org.dronemap.core.time.RealTime;
import org.junit.jupiter.api.Test;

/** What becomes of telemetry while its tables do not take anything, or are not there. */
class TelemetryOutageTest {
    private static final Instant START = Instant.parse("2026-03-04T05:06:07Z");
    private static final DroneId DRONE = new DroneId("copter-1");
    private static final int ROOM = 100;
    private static final TelemetryWriter.BatchSettings QUICK =
            new TelemetryWriter.BatchSettings(Duration.ofMillis(10), 50, ROOM, Duration.ofMillis(50));

    private final PostgresStores database = SharedDatabase.empty();
    private final TelemetryWriter writer = new TelemetryWriter(database.telemetry(), QUICK, new RealTime());
    private int brought;

    @Test
    void aStoreThatStandsStillCostsCountedTelemetryAndHoldsNobodyUp() throws SQLException {
        writer.start();
        try (Connection other = database.dataSource().getConnection();
                Statement statement = other.createStatement()) {
            other.setAutoCommit(false);
            statement.execute("LOCK TABLE telemetry IN ACCESS EXCLUSIVE MODE");
            bring(10 * ROOM);
            assertThat(writer.health().dropped()).isPositive();
            assertThat(writer.health().isUp()).isFalse();
            other.rollback();
        }

        assertAllIsWrittenOrCounted();
    }

    @Test
    void aStoreThatRefusesIsTriedAgainUntilItTakesWhatWaits() throws SQLException {
        writer.start();
        execute("ALTER TABLE telemetry RENAME TO telemetry_away");
        try {
            bring(ROOM / 2);
            await().atMost(Duration.ofSeconds(30)).until(() -> !writer.health().isUp());
            assertThat(writer.health().trouble()).contains("telemetry");
        } finally {
            execute("ALTER TABLE telemetry_away RENAME TO telemetry");
        }

        assertAllIsWrittenOrCounted();
    }

    private void assertAllIsWrittenOrCounted() {
        await().atMost(Duration.ofSeconds(60)).until(() -> writer.health().waiting() == 0);
        HistoryHealth health = writer.health();
        List<TelemetryPoint> kept = new ArrayList<>();
        database.telemetry().points(DRONE, new TimeRange(START, START.plusSeconds(86_400)), kept::add);
        assertThat(kept.size() + health.dropped()).isEqualTo(brought);
        assertThat(health.written()).isEqualTo(kept.size());
        writer.close();
    }

    private void bring(int points) {
        for (int i = 0; i < points; i++) {
            writer.point(new TelemetryPoint(
                    DRONE,
                    START.plusSeconds(brought++),
                    null,
                    null,
                    null,
                    null,
                    null,
                    LinkState.LIVE,
                    LinkQuality.UNKNOWN,
                    null,
                    true,
                    null,
                    null));
        }
    }

    private void execute(String sql) throws SQLException {
        try (Connection connection = database.dataSource().getConnection();
                Statement statement = connection.createStatement()) {
            statement.execute(sql);
        }
    }
}
