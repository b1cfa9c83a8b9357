package org.dronemap.store.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Stream;
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
import org.dronemap.core.history.HistoryHealth;
import org.dronemap.core.history.Retention;
import org.dronemap.core.history.SeriesQuery;
import org.dronemap.core.history.Span;
import org.dronemap.core.history.TelemetryField;
import org.dronemap.core.history.TelemetryPoint;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.core.history.TelemetryWriter;
import org.dronemap.store.postgres.Database;

/**
 * Brings so many points a second for so many seconds, fills up to so many points, and looks at one hour of one drone. Prints
 * JSON. Arguments: directory of the server's own PostgreSQL, points a second, seconds, points in all.
 */
public final class TelemetryBenchmark {
    private static final int DRONES = 2_000;
    private static final int LOOKS = 15;
    private static final double NANOS = 1e9;

    private final TelemetryStore store;
    private final int rate;
    private final int seconds;
    private final long total;
    private long brought;

    private TelemetryBenchmark(TelemetryStore store, int rate, int seconds, long total) {
        this.store = store;
        this.rate = rate;
        this.seconds = seconds;
        this.total = total;
    }

    public static void main(String[] arguments) throws IOException {
        Path directory = Path.of(arguments[0]);
        try (Database database = Database.openOwn(directory)) {
            TelemetryBenchmark benchmark = new TelemetryBenchmark(
                    database.telemetry(),
                    Integer.parseInt(arguments[1]),
                    Integer.parseInt(arguments[2]),
                    Long.parseLong(arguments[3]));
            System.out.println(benchmark.run(directory));
        }
    }

    private String run(Path directory) throws IOException {
        // All of one day, so that what is looked at lies in one table with everything else.
        Instant begin = Instant.now().minus(Duration.ofDays(1)).truncatedTo(ChronoUnit.DAYS);
        store.tidy(new Retention(0, 0, Duration.ofSeconds(10)), begin);
        String written = write(begin, directory);
        long from = System.nanoTime();
        long before = brought;
        while (brought < total) {
            store.append(batch(begin, 20_000), List.of());
        }
        double filled = brought == before ? 0 : (brought - before) / ((System.nanoTime() - from) / NANOS);
        double[] looks = looks(begin);
        return String.format(
                Locale.ROOT,
                "{\"server\":\"%s\",%s,\"fillPointsPerSecond\":%.0f,\"points\":%d,\"drones\":%d,"
                        + "\"pointsInTheHour\":%d,\"hourMillisMedian\":%.1f,\"hourMillisWorst\":%.1f}",
                store.server(),
                written,
                filled,
                brought,
                DRONES,
                Math.min(brought / DRONES, 3_600L * rate / DRONES),
                looks[LOOKS / 2],
                looks[LOOKS - 1]);
    }

    private String write(Instant begin, Path directory) throws IOException {
        TelemetryWriter writer = new TelemetryWriter(store, TelemetryWriter.Rhythm.DEFAULT);
        writer.start();
        double ownBefore = ownSeconds();
        double databaseBefore = databaseSeconds(directory);
        long start = System.nanoTime();
        long all = (long) rate * seconds;
        while (brought < all) {
            long due = Math.min(all, (long) ((System.nanoTime() - start) / NANOS * rate));
            while (brought < due) {
                writer.point(next(begin));
            }
            LockSupport.parkNanos(5_000_000);
        }
        double took = (System.nanoTime() - start) / NANOS;
        double own = (ownSeconds() - ownBefore) / took;
        double database = (databaseSeconds(directory) - databaseBefore) / took;
        writer.close();
        HistoryHealth health = writer.health();
        return String.format(
                Locale.ROOT,
                "\"pointsPerSecond\":%.0f,\"seconds\":%.1f,\"written\":%d,\"dropped\":%d,\"ownCores\":%.2f,\"databaseCores\":%.2f",
                brought / took,
                took,
                health.written(),
                health.dropped(),
                own,
                database);
    }

    private List<TelemetryPoint> batch(Instant begin, int size) {
        List<TelemetryPoint> points = new ArrayList<>(size);
        for (int i = 0; i < size; i++) {
            points.add(next(begin));
        }
        points.sort((one, other) -> one.drone().value().compareTo(other.drone().value()));
        return points;
    }

    /** Drone after drone, each as often as the rate gives. */
    private TelemetryPoint next(Instant begin) {
        int drone = (int) (brought % DRONES);
        long round = brought / DRONES;
        double second = (double) round * DRONES / rate;
        brought++;
        double wave = Math.sin(second / 60 + drone);
        return new TelemetryPoint(
                new DroneId("d" + (100_000 + drone)),
                begin.plusNanos((long) (second * NANOS)),
                new Position(new Geodetic(47 + wave * 0.01, 8 + drone * 1e-4), 500 + 50 * wave, 50 + 50 * wave),
                new Motion(5 + wave, null, wave, (second * 3) % 360),
                new Attitude(wave * 10, -wave * 10, (second * 3) % 360 - 180),
                new Battery(100 - (int) (second / 60) % 100, 12.6 - wave, 14.5),
                new Gps(GpsFix.THREE_D, 14, 0.8),
                LinkState.LIVE,
                new LinkQuality(0.01, 0.01, 35.5),
                "AUTO",
                true,
                FlightPhase.IN_AIR,
                (int) (second / 30) % 20);
    }

    private double[] looks(Instant begin) {
        double[] millis = new double[LOOKS];
        for (int i = 0; i < LOOKS; i++) {
            SeriesQuery query = new SeriesQuery(
                    new DroneId("d" + (100_000 + i * 131)),
                    new Span(begin, begin.plus(Duration.ofHours(1))),
                    List.of(
                            TelemetryField.ALTITUDE_ABOVE_HOME,
                            TelemetryField.GROUND_SPEED,
                            TelemetryField.BATTERY_PERCENT,
                            TelemetryField.LOSS_SHORT),
                    1_500);
            long from = System.nanoTime();
            store.series(query);
            millis[i] = (System.nanoTime() - from) / 1e6;
        }
        Arrays.sort(millis);
        return millis;
    }

    private static double ownSeconds() {
        return ProcessHandle.current()
                        .info()
                        .totalCpuDuration()
                        .orElse(Duration.ZERO)
                        .toNanos()
                / NANOS;
    }

    /** Of all processes that work in that directory, those that have ended since included. */
    private static double databaseSeconds(Path directory) throws IOException {
        double ticks = 0;
        try (Stream<Path> processes = Files.list(Path.of("/proc"))) {
            for (Path process : processes.filter(TelemetryBenchmark::isProcess).toList()) {
                ticks += ticks(process, directory);
            }
        }
        return ticks / 100;
    }

    private static boolean isProcess(Path path) {
        return path.getFileName().toString().matches("\\d+");
    }

    private static double ticks(Path process, Path directory) {
        try {
            if (!process.resolve("cwd").toRealPath().startsWith(directory.toRealPath())) {
                return 0;
            }
            String stat = Files.readString(process.resolve("stat"));
            String[] fields = stat.substring(stat.lastIndexOf(')') + 2).split(" ");
            return Double.parseDouble(fields[11]) + Double.parseDouble(fields[12]);
        } catch (IOException gone) {
            return 0;
        }
    }
}
