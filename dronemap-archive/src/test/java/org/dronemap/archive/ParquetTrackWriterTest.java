package org.dronemap.archive;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.apache.hadoop.conf.Configuration;
import org.apache.parquet.example.data.Group;
import org.apache.parquet.hadoop.ParquetFileReader;
import org.apache.parquet.hadoop.ParquetReader;
import org.apache.parquet.hadoop.example.GroupReadSupport;
import org.apache.parquet.hadoop.util.HadoopInputFile;
import org.apache.parquet.schema.MessageType;
import org.dronemap.core.drone.Attitude;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Gps;
import org.dronemap.core.drone.GpsFix;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.history.TelemetryColumn;
import org.dronemap.core.history.TelemetryPoint;
import org.dronemap.store.parquet.ParquetTrackWriter;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What the server hands out as Parquet is, to the library that made the format, a file of the archive's kind. */
@Tag("soak")
class ParquetTrackWriterTest {
    private static final int SEVERAL_PAGES = 50_003;

    @TempDir
    private Path folder;

    @Test
    void hasTheSchemaOfTheArchive() throws IOException {
        assertThat(schema(written(points(3)))).isEqualTo(ParquetColumns.schema());
    }

    @Test
    void givesEachPointBackAsItIs() throws IOException {
        List<TelemetryPoint> points = points(SEVERAL_PAGES);

        List<List<@Nullable Object>> rows = rows(written(points));

        assertThat(rows).hasSize(SEVERAL_PAGES);
        for (int i = 0; i < points.size(); i++) {
            assertThat(rows.get(i)).isEqualTo(expected(points.get(i)));
        }
    }

    @Test
    void isAFileWithoutRowsWhereThereAreNoPoints() throws IOException {
        Path file = written(List.of());

        assertThat(rows(file)).isEmpty();
        assertThat(schema(file)).isEqualTo(ParquetColumns.schema());
    }

    private Path written(List<TelemetryPoint> points) throws IOException {
        Path file = folder.resolve(points.size() + ".parquet");
        try (OutputStream out = Files.newOutputStream(file)) {
            new ParquetTrackWriter().write(points, out);
        }
        return file;
    }

    private static MessageType schema(Path file) throws IOException {
        try (ParquetFileReader reader = ParquetFileReader.open(
                HadoopInputFile.fromPath(new org.apache.hadoop.fs.Path(file.toUri()), new Configuration()))) {
            return reader.getFileMetaData().getSchema();
        }
    }

    private static List<List<@Nullable Object>> rows(Path file) throws IOException {
        List<List<@Nullable Object>> rows = new ArrayList<>();
        try (ParquetReader<Group> reader = ParquetReader.builder(
                        new GroupReadSupport(), new org.apache.hadoop.fs.Path(file.toUri()))
                .build()) {
            for (Group row = reader.read(); row != null; row = reader.read()) {
                rows.add(ParquetColumns.read(row));
            }
        }
        return rows;
    }

    private static List<@Nullable Object> expected(TelemetryPoint point) {
        List<@Nullable Object> values = new ArrayList<>();
        TelemetryColumn.ALL.forEach(column -> values.add(column.of(point)));
        return values;
    }

    /** Many facts among them not known. */
    private static List<TelemetryPoint> points(int count) {
        Random random = new Random(11);
        List<TelemetryPoint> points = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            Instant at = Instant.parse("2026-03-04T05:06:07.000001Z").plusMillis(200L * i);
            points.add(point(at, random));
        }
        return points;
    }

    private static TelemetryPoint point(Instant at, Random random) {
        double some = random.nextGaussian();
        return new TelemetryPoint(
                new DroneId("copter-1"),
                at,
                random.nextBoolean() ? null : new Position(new Geodetic(47 + some, 8 - some), 400 + some, null),
                random.nextBoolean() ? null : new Motion(some, null, -some, 90 + some),
                random.nextBoolean() ? null : new Attitude(some, -some, 10 * some),
                random.nextBoolean() ? null : new Battery(random.nextInt(101), 12 + some, null),
                random.nextBoolean() ? null : new Gps(GpsFix.THREE_D, random.nextInt(30), 0.8),
                LinkState.LIVE,
                new LinkQuality(0.25, null, random.nextDouble()),
                random.nextBoolean() ? null : "Grüße 😀",
                random.nextInt(3) == 0 ? null : (Boolean) random.nextBoolean(),
                random.nextBoolean() ? null : FlightPhase.IN_AIR,
                random.nextBoolean() ? null : (Integer) random.nextInt());
    }
}
