package org.dronemap.store.bench;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Duration;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.dronemap.store.postgres.PostgresStores;

/** Kills a process that remembers states, again and again, and looks at what of them is there afterwards. */
final class KillTrials {
    private static final int LEAST_MILLIS = 3_000;
    private static final int MOST_MILLIS = 7_000;

    private final Path directory;
    private final int rate;
    private final Random random = new Random(7);

    /**
     * What was missing after one kill.
     *
     * @param lostSeconds from the newest state that is there until the process was gone
     * @param missing states before the newest one that are not there
     */
    record Loss(double lostSeconds, long missing) {}

    KillTrials(Path directory, int rate) {
        this.directory = directory;
        this.rate = rate;
    }

    List<Loss> kill(int times) throws IOException, InterruptedException, SQLException {
        List<Loss> losses = new ArrayList<>();
        for (int i = 0; i < times; i++) {
            losses.add(killOnce());
        }
        return losses;
    }

    private Loss killOnce() throws IOException, InterruptedException, SQLException {
        Instant begin = Instant.now();
        Instant gone = writeAndKill();
        try (PostgresStores database = PostgresStores.openOwn(directory)) {
            return loss(database, begin, gone);
        }
    }

    private Instant writeAndKill() throws IOException, InterruptedException {
        String java = ProcessHandle.current().info().command().orElse("java");
        Process writer = new ProcessBuilder(
                        java,
                        "-Xmx384m",
                        "-cp",
                        System.getProperty("java.class.path"),
                        KilledWriter.class.getName(),
                        directory.toString(),
                        Integer.toString(rate))
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        try (BufferedReader out =
                new BufferedReader(new InputStreamReader(writer.getInputStream(), StandardCharsets.UTF_8))) {
            String line = out.readLine();
            while (line != null && !line.equals(KilledWriter.UNDER_WAY)) {
                line = out.readLine();
            }
            int millis = LEAST_MILLIS + random.nextInt(MOST_MILLIS - LEAST_MILLIS);
            if (line == null || writer.waitFor(millis, TimeUnit.MILLISECONDS)) {
                throw new IOException("the process that writes has ended by itself");
            }
            writer.destroyForcibly().waitFor();
            return Instant.now();
        }
    }

    private static Loss loss(PostgresStores database, Instant begin, Instant gone) throws SQLException {
        try (Connection connection = database.dataSource().getConnection();
                PreparedStatement statement = connection.prepareStatement(
                        "SELECT max(at), count(DISTINCT latitude), max(latitude) FROM telemetry WHERE at >= ?")) {
            statement.setObject(1, begin.atOffset(ZoneOffset.UTC));
            try (ResultSet result = statement.executeQuery()) {
                result.next();
                OffsetDateTime newest = result.getObject(1, OffsetDateTime.class);
                if (newest == null) {
                    throw new SQLException("nothing at all was kept");
                }
                long numbers = Math.round(result.getDouble(3) / BenchmarkFleet.DEGREES_APART) + 1;
                double lost = Duration.between(newest.toInstant(), gone).toNanos() / 1e9;
                return new Loss(lost, numbers - result.getLong(2));
            }
        }
    }
}
