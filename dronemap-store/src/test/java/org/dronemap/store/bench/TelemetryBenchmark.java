package org.dronemap.store.bench;

import java.io.IOException;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.history.HistoryHealth;
import org.dronemap.core.history.Retention;
import org.dronemap.core.history.SeriesQuery;
import org.dronemap.core.history.TelemetryField;
import org.dronemap.core.history.TelemetryPoint;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.core.history.TimeRange;
import org.dronemap.store.postgres.PostgresStores;

/**
 * Brings so many states a second for so many seconds, kills such a writer so many times, fills up to so many points, and looks
 * at one hour of one drone. Prints JSON, and fails when a goal is missed. Arguments: directory for a PostgreSQL, states a
 * second, seconds, points in all, kills.
 */
public final class TelemetryBenchmark {
    /** Drones that get a full hour, five states a second. */
    private static final int LONG_FLIGHTS = 400;

    private static final Duration APART = Duration.ofMillis(200);
    private static final int FILL = 20_000;
    private static final int LOOKS = 40;
    private static final int SLOTS = 1_500;
    private static final Retention FOR_EVER = new Retention(0, 0, Duration.ofSeconds(10));
    private static final Duration HOUR = Duration.ofHours(1);
    private static final double MOST_CORES = 1;
    private static final double MOST_MILLIS = 100;
    private static final double MOST_LOST_SECONDS = 1;

    private final Path directory;
    private final int rate;
    private final int seconds;
    private final long total;
    /** All of one day, so that what is looked at lies in one table with everything else. */
    private final Instant begin = Instant.now().minus(Duration.ofDays(2)).truncatedTo(ChronoUnit.DAYS);

    private final List<String> missed = new ArrayList<>();

    private TelemetryBenchmark(Path directory, int rate, int seconds, long total) {
        this.directory = directory;
        this.rate = rate;
        this.seconds = seconds;
        this.total = total;
    }

    public static void main(String[] arguments) throws IOException, SQLException, InterruptedException {
        Path directory = Path.of(arguments[0]);
        int rate = Integer.parseInt(arguments[1]);
        TelemetryBenchmark benchmark =
                new TelemetryBenchmark(directory, rate, Integer.parseInt(arguments[2]), Long.parseLong(arguments[3]));
        List<String> parts = new ArrayList<>();
        parts.add("\"machine\": \"" + ProcessorTime.model() + "\"");
        parts.add("\"java\": \"" + Runtime.version() + "\"");
        try (PostgresStores database = PostgresStores.openOwn(directory)) {
            parts.add("\"server\": \"" + database.telemetry().server() + "\"");
            parts.add(benchmark.write(database));
            parts.add(benchmark.look(database));
        }
        parts.add(benchmark.killed(new KillTrials(directory, rate).kill(Integer.parseInt(arguments[4]))));
        String missed = benchmark.missed.stream().map(goal -> '"' + goal + '"').collect(Collectors.joining(", "));
        parts.add("\"missedGoals\": [" + missed + "]");
        System.out.println("{\n  " + String.join(",\n  ", parts) + "\n}");
        System.exit(missed.isEmpty() ? 0 : 1);
    }

    private void goal(String words, boolean reached) {
        if (!reached) {
            missed.add(words);
        }
    }

    private String write(PostgresStores database) throws IOException, SQLException {
        database.telemetry().tidy(FOR_EVER, begin);
        long all = (long) rate * seconds;
        ProcessorTime before = ProcessorTime.now(directory);
        double took;
        ProcessorTime used;
        OpenLoopLoad written = new OpenLoopLoad(database, rate);
        try (OpenLoopLoad loop = written) {
            took = loop.bring(all, number -> begin.plusNanos((long) (number * 1e9 / rate)));
            used = ProcessorTime.now(directory).since(before);
        }
        HistoryHealth health = written.health();
        long kept = count(database);
        goal("no point is missing", kept == all && health.dropped() == 0);
        goal("the server takes no more than one core", used.own() / took <= MOST_CORES);
        return String.format(
                Locale.ROOT,
                "\"writing\": {\"drones\": %d, \"pointsPerSecond\": %.0f, \"seconds\": %.1f, \"brought\": %d, \"inTheDatabase\": %d,"
                        + " \"dropped\": %d, \"serverCores\": %.2f, \"databaseCores\": %.2f, \"otherCores\": %.2f}",
                BenchmarkFleet.DRONES,
                all / took,
                took,
                all,
                kept,
                health.dropped(),
                used.own() / took,
                used.database() / took,
                (used.machine() - used.own() - used.database()) / took);
    }

    private static long count(PostgresStores database) throws SQLException {
        try (Connection connection = database.dataSource().getConnection();
                Statement statement = connection.createStatement();
                ResultSet result = statement.executeQuery("SELECT count(*) FROM telemetry")) {
            result.next();
            return result.getLong(1);
        }
    }

    private String look(PostgresStores database) throws SQLException, IOException {
        Instant first = begin.plusSeconds(seconds);
        long from = System.nanoTime();
        long filled = fill(database.telemetry(), total - count(database), first);
        double filling = (System.nanoTime() - from) / 1e9;
        double[] asWritten = looks(database.telemetry(), first);
        ProcessorTime before = ProcessorTime.now(directory);
        from = System.nanoTime();
        // What the server does when a day is over.
        database.telemetry().tidy(FOR_EVER, begin.plus(Duration.ofDays(2)));
        double sorting = (System.nanoTime() - from) / 1e9;
        double sortingCpu = ProcessorTime.now(directory).since(before).database();
        before = ProcessorTime.now(directory);
        double[] sorted = looks(database.telemetry(), first);
        ProcessorTime looking = ProcessorTime.now(directory).since(before);
        goal("an hour of one drone in 100 ms", sorted[LOOKS / 2] < MOST_MILLIS);
        int[] states = {0};
        database.telemetry().points(looked(0), hour(first), point -> states[0]++);
        return String.format(
                Locale.ROOT,
                "\"filling\": {\"points\": %d, \"pointsPerSecond\": %.0f},\n  \"looking\": {\"points\": %d, \"pointsInTheHour\": %d,"
                        + " \"slots\": %d, \"fields\": 4, \"looks\": %d, \"medianMillis\": %.1f, \"worstMillis\": %.1f, \"cpuMillis\": %.1f,"
                        + " \"asWrittenMedianMillis\": %.1f, \"asWrittenWorstMillis\": %.1f,"
                        + " \"sortingSeconds\": %.1f, \"sortingDatabaseCpuSeconds\": %.1f}",
                filled,
                filled / filling,
                count(database),
                states[0],
                SLOTS,
                LOOKS,
                sorted[LOOKS / 2],
                sorted[LOOKS - 1],
                (looking.own() + looking.database()) * 1_000 / LOOKS,
                asWritten[LOOKS / 2],
                asWritten[LOOKS - 1],
                sorting,
                sortingCpu);
    }

    /** Some drones fly on, at the rate at which a server keeps states when it is not told otherwise. */
    private static long fill(TelemetryStore store, long points, Instant from) {
        long filled = 0;
        while (filled < points) {
            List<TelemetryPoint> batch = new ArrayList<>(FILL);
            for (int i = 0; i < FILL; i++, filled++) {
                Instant at = from.plus(APART.multipliedBy(filled / LONG_FLIGHTS));
                DroneId drone = looked(filled);
                batch.add(TelemetryPoint.of(BenchmarkFleet.state(filled, drone, at)));
            }
            store.append(batch, List.of());
        }
        return filled;
    }

    private static DroneId looked(long number) {
        return BenchmarkFleet.drone(number % LONG_FLIGHTS * (BenchmarkFleet.DRONES / LONG_FLIGHTS));
    }

    private static TimeRange hour(Instant from) {
        return new TimeRange(from, from.plus(HOUR));
    }

    /** Each at another drone, so that what one look has read is of no use to the next. */
    private static double[] looks(TelemetryStore store, Instant first) {
        double[] millis = new double[LOOKS];
        for (int i = 0; i < LOOKS; i++) {
            SeriesQuery query = new SeriesQuery(
                    looked(i * 7L),
                    hour(first),
                    List.of(
                            TelemetryField.ALTITUDE_ABOVE_HOME,
                            TelemetryField.GROUND_SPEED,
                            TelemetryField.BATTERY_PERCENT,
                            TelemetryField.LOSS_SHORT),
                    SLOTS);
            long from = System.nanoTime();
            store.series(query);
            millis[i] = (System.nanoTime() - from) / 1e6;
        }
        Arrays.sort(millis);
        return millis;
    }

    private String killed(List<KillTrials.Loss> losses) {
        String seconds = losses.stream()
                .map(loss -> String.format(Locale.ROOT, "%.2f", loss.lostSeconds()))
                .collect(Collectors.joining(", "));
        long missing = losses.stream().mapToLong(KillTrials.Loss::missing).sum();
        goal(
                "a kill costs a second at most",
                losses.stream().allMatch(loss -> loss.lostSeconds() <= MOST_LOST_SECONDS));
        goal("nothing before that second is missing", missing == 0);
        return "\"kills\": {\"lostSeconds\": [" + seconds + "], \"missingBefore\": " + missing + "}";
    }
}
