package org.dronemap.archive;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.sql.SQLException;
import java.time.Instant;
import java.time.LocalDate;
import java.util.ArrayList;
import java.util.List;
import org.apache.hadoop.conf.Configuration;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.history.TelemetryPoint;
import org.dronemap.store.postgres.PostgresStores;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What the server itself wrote down is archived. */
@Tag("soak")
class DatabaseRowSourceTest {
    private static final LocalDate DAY = LocalDate.of(2026, 3, 4);

    @Test
    void archivesWhatTheServerWroteOfFinishedDays(@TempDir Path folder) throws SQLException, IOException {
        try (PostgresStores database = PostgresStores.openOwn(folder.resolve("postgres"))) {
            Instant last = Instant.parse("2026-03-04T23:59:59.999999Z");
            List<TelemetryPoint> batch =
                    List.of(point("b", last), point("a", last), point("a", last.minusSeconds(1)), point("a", last));
            database.telemetry().append(batch, List.of());
            database.telemetry().append(List.of(point("a", last.plusSeconds(60))), List.of());
            try (DatabaseRowSource rows = new DatabaseRowSource(database.dataSource().getConnection())) {
                assertThat(rows.finished(Instant.parse("2026-03-05T00:30:00Z"))).isEmpty();
                assertThat(rows.finished(Instant.parse("2026-03-05T01:30:00Z"))).containsExactly(DAY);
                // Comes after the archive was opened: of the next run.
                database.telemetry().append(List.of(point("c", last)), List.of());
                DayArchive archive = new DayArchive(
                        new org.apache.hadoop.fs.Path(folder.resolve("archive").toUri()), new Configuration(), rows);

                assertThat(archive.keep(DAY)).isEqualTo(new DayArchive.Result(DayArchive.Status.WRITTEN, 3));

                List<List<@Nullable Object>> kept = new ArrayList<>();
                archive.read(DAY, kept::add);
                assertThat(kept).extracting(row -> row.get(0)).containsExactly("a", "a", "b");
                assertThat(kept.get(1).subList(1, 6))
                        .containsExactly(1_772_668_799_999_999L, 47.123456789, 8.5, 400.5f, null);
            }
        }
    }

    private static TelemetryPoint point(String drone, Instant at) {
        return new TelemetryPoint(
                new DroneId(drone),
                at,
                new Position(new Geodetic(47.123456789, 8.5), 400.5, null),
                null,
                null,
                new Battery(77, null, null),
                null,
                LinkState.LIVE,
                LinkQuality.UNKNOWN,
                "AUTO",
                true,
                null,
                3);
    }
}
