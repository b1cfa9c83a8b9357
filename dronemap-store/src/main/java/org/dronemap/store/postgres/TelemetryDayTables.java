package org.dronemap.store.postgres;

import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.sql.DataSource;
import org.dronemap.core.history.Retention;
import org.dronemap.core.history.TelemetryDownsampler;
import org.dronemap.core.history.TelemetryPoint;
import org.jspecify.annotations.Nullable;
import org.postgresql.copy.CopyIn;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Creates, sorts, thins and drops the PostgreSQL tables that each hold one day (UTC) of telemetry. Rows come in the
 * order of time, a few of each drone at once; sorted, an hour of one drone lies together, and is read ten times as fast
 * where many flew.
 */
final class TelemetryDayTables {
    private static final Logger LOG = LoggerFactory.getLogger(TelemetryDayTables.class);
    private static final int DAYS_AHEAD = 2;
    private static final int ROWS_AT_ONCE = 5_000;
    private static final int LONGEST_MILLIS = 3_600_000;
    /** A day has most of its late rows when it has been over for so long. */
    private static final Duration LATE = Duration.ofHours(1);

    private static final Pattern NAME = Pattern.compile("telemetry_(\\d{8})(_sorted|_thin)?");
    private static final DateTimeFormatter NAMED = DateTimeFormatter.BASIC_ISO_DATE;

    private final DataSource dataSource;
    private final DayWriteGuard gate;

    /** The layout of a day's rows, with the suffix of its table's name. */
    private enum RowLayout {
        AS_WRITTEN(""),
        SORTED("_sorted"),
        THINNED("_thin");

        private final String ending;

        RowLayout(String ending) {
            this.ending = ending;
        }

        static RowLayout ending(@Nullable String ending) {
            return Arrays.stream(values())
                    .filter(form -> form.ending.equals(ending))
                    .findFirst()
                    .orElse(AS_WRITTEN);
        }
    }

    /** A day that has a table. */
    private record Day(LocalDate date, RowLayout form) {
        String table() {
            return TelemetryDayTables.table(date) + form.ending;
        }
    }

    TelemetryDayTables(DataSource dataSource, DayWriteGuard gate) {
        this.dataSource = dataSource;
        this.gate = gate;
    }

    void tidy(Retention retention, Instant now) {
        try {
            LocalDate today = LocalDate.ofInstant(now, ZoneOffset.UTC);
            drop(retention.firstKept(now));
            for (LocalDate day : missing(today)) {
                make(day);
            }
            thin(retention, retention.firstFull(now));
            sort(LocalDate.ofInstant(now.minus(LATE), ZoneOffset.UTC));
        } catch (SQLException e) {
            throw SqlErrorMessages.exception(e);
        }
    }

    /** Today and the next days, and those that have rows but no table. */
    private Set<LocalDate> missing(LocalDate today) throws SQLException {
        Set<LocalDate> days = new TreeSet<>();
        for (int i = 0; i <= DAYS_AHEAD; i++) {
            days.add(today.plusDays(i));
        }
        try (Connection connection = dataSource.getConnection();
                Statement statement = connection.createStatement();
                ResultSet result = statement.executeQuery(
                        "SELECT DISTINCT to_char(at AT TIME ZONE 'UTC', 'YYYYMMDD') FROM telemetry_other")) {
            while (result.next()) {
                days.add(LocalDate.parse(result.getString(1), NAMED));
            }
        }
        days().forEach(day -> days.remove(day.date()));
        return days;
    }

    private List<Day> days() throws SQLException {
        List<Day> days = new ArrayList<>();
        try (Connection connection = dataSource.getConnection();
                Statement statement = connection.createStatement();
                ResultSet result = statement.executeQuery("SELECT c.relname FROM pg_inherits i"
                        + " JOIN pg_class c ON c.oid = i.inhrelid WHERE i.inhparent = 'telemetry'::regclass")) {
            while (result.next()) {
                Matcher name = NAME.matcher(result.getString(1));
                if (name.matches()) {
                    days.add(new Day(LocalDate.parse(name.group(1), NAMED), RowLayout.ending(name.group(2))));
                }
            }
        }
        return days;
    }

    /** What has come for that day already, because it had no table, moves into it. */
    private void make(LocalDate day) throws SQLException {
        withLockTimeout(connection -> {
            execute(connection, "LOCK TABLE telemetry_other IN ACCESS EXCLUSIVE MODE");
            create(connection, table(day));
            execute(
                    connection,
                    "WITH moved AS (DELETE FROM telemetry_other WHERE at >= " + begin(day) + " AND at < "
                            + begin(day.plusDays(1)) + " RETURNING *) INSERT INTO " + table(day)
                            + " SELECT * FROM moved");
            attach(connection, table(day), day);
        });
    }

    private void drop(@Nullable LocalDate firstKept) throws SQLException {
        if (firstKept == null) {
            return;
        }
        for (Day day : days()) {
            if (day.date().isBefore(firstKept)) {
                withLockTimeout(connection -> execute(connection, "DROP TABLE " + day.table()));
                LOG.info("The telemetry of {} was dropped, for its time was over", day.date());
            }
        }
        withLockTimeout(connection -> {
            execute(connection, "DELETE FROM telemetry_other WHERE at < " + begin(firstKept));
            PostgresEventSeries.drop(
                    connection, firstKept.atStartOfDay(ZoneOffset.UTC).toInstant());
        });
    }

    private void thin(Retention retention, @Nullable LocalDate firstFull) throws SQLException {
        for (Day day : days()) {
            if (firstFull != null
                    && day.form() != RowLayout.THINNED
                    && day.date().isBefore(firstFull)) {
                withLockTimeout(connection -> thin(connection, day, retention));
                LOG.info("The telemetry of {} was thinned", day.date());
            }
        }
    }

    private void thin(Connection connection, Day day, Retention retention) throws SQLException {
        Day thinned = new Day(day.date(), RowLayout.THINNED);
        create(connection, thinned.table());
        List<TelemetryPoint> kept = new ArrayList<>();
        TelemetryDownsampler thinning = new TelemetryDownsampler(retention.thinned(), kept::add);
        String sql = "SELECT " + TelemetryRows.ALL + " FROM " + day.table() + " ORDER BY drone_id, at";
        // On a connection of its own: one cannot read and copy at the same time.
        try (Connection reading = dataSource.getConnection();
                TableCopy copy = new TableCopy(connection, thinned.table())) {
            reading.setAutoCommit(false);
            reading.setNetworkTimeout(Runnable::run, LONGEST_MILLIS);
            try (PreparedStatement statement = reading.prepareStatement(sql)) {
                statement.setFetchSize(ROWS_AT_ONCE);
                try (ResultSet result = statement.executeQuery()) {
                    while (result.next()) {
                        thinning.add(TelemetryRows.read(new ResultRow(result)));
                        copy.all(kept);
                    }
                }
                thinning.finish();
                copy.all(kept);
                copy.finish();
            } finally {
                reading.rollback();
            }
        }
        replace(connection, day, thinned);
    }

    private static void replace(Connection connection, Day day, Day by) throws SQLException {
        execute(connection, "ALTER TABLE telemetry DETACH PARTITION " + day.table());
        execute(connection, "DROP TABLE " + day.table());
        attach(connection, by.table(), day.date());
    }

    private void sort(LocalDate firstUnfinished) throws SQLException {
        for (Day day : days()) {
            if (day.form() == RowLayout.AS_WRITTEN && day.date().isBefore(firstUnfinished)) {
                sort(day, new Day(day.date(), RowLayout.SORTED));
            }
        }
    }

    /** Rows that come late for that day meanwhile put it off; the batches of today wait for the short end of it alone. */
    private void sort(Day day, Day sorted) throws SQLException {
        gate.watch(day.date());
        // On its own: what was written is brought to the disk at the end, which may take long.
        withLockTimeout(connection -> fill(connection, day, sorted));
        if (gate.whileUntouched(() -> withLockTimeout(connection -> replace(connection, day, sorted)))) {
            withLockTimeout(
                    connection -> execute(connection, "ALTER TABLE " + sorted.table() + " DROP CONSTRAINT of_day"));
            LOG.info("The telemetry of {} was sorted by drone", day.date());
        } else {
            withLockTimeout(connection -> execute(connection, "DROP TABLE " + sorted.table()));
            LOG.info("The telemetry of {} is sorted later, for more of it has come meanwhile", day.date());
        }
    }

    private static void fill(Connection connection, Day day, Day sorted) throws SQLException {
        // A server that ended in the middle leaves one behind.
        execute(connection, "DROP TABLE IF EXISTS " + sorted.table());
        create(connection, sorted.table());
        // Known to hold, it need not be looked for in all rows when the table takes its place.
        execute(
                connection,
                "ALTER TABLE " + sorted.table() + " ADD CONSTRAINT of_day CHECK (at >= " + begin(day.date())
                        + " AND at < " + begin(day.date().plusDays(1)) + ")");
        execute(connection, "SET LOCAL work_mem = '32MB'");
        // One row after the other through the index would read each page of the day many times.
        execute(connection, "SET LOCAL enable_indexscan = off");
        execute(
                connection,
                "INSERT INTO " + sorted.table() + " SELECT * FROM " + day.table() + " ORDER BY drone_id, at");
    }

    /** A copy that ends with its block, finished or not. */
    private static final class TableCopy implements AutoCloseable {
        private final CopyIn copy;
        private final CopyBuffer out;

        TableCopy(Connection connection, String table) throws SQLException {
            this.copy = TelemetryRows.copyIn(connection, table);
            this.out = new CopyBuffer(copy);
        }

        void all(List<TelemetryPoint> points) throws SQLException {
            for (TelemetryPoint point : points) {
                TelemetryRows.write(point, out);
            }
            points.clear();
        }

        void finish() throws SQLException {
            out.end();
        }

        @Override
        public void close() throws SQLException {
            if (copy.isActive()) {
                copy.cancelCopy();
            }
        }
    }

    private interface DatabaseWork {
        void on(Connection connection) throws SQLException;
    }

    /** In one transaction, however long the work itself takes; but nobody is held up for long by its locks. */
    private void withLockTimeout(DatabaseWork work) throws SQLException {
        try (Connection connection = dataSource.getConnection()) {
            int usual = connection.getNetworkTimeout();
            connection.setNetworkTimeout(Runnable::run, LONGEST_MILLIS);
            connection.setAutoCommit(false);
            try {
                execute(connection, "SET LOCAL lock_timeout = '3s'");
                work.on(connection);
                connection.commit();
            } catch (SQLException | RuntimeException e) {
                connection.rollback();
                throw e;
            } finally {
                connection.setNetworkTimeout(Runnable::run, usual);
            }
        }
    }

    private static void create(Connection connection, String table) throws SQLException {
        execute(connection, "CREATE TABLE " + table + " (LIKE telemetry INCLUDING DEFAULTS INCLUDING INDEXES)");
    }

    private static void attach(Connection connection, String table, LocalDate day) throws SQLException {
        execute(
                connection,
                "ALTER TABLE telemetry ATTACH PARTITION " + table + " FOR VALUES FROM (" + begin(day) + ") TO ("
                        + begin(day.plusDays(1)) + ")");
    }

    private static void execute(Connection connection, String sql) throws SQLException {
        try (Statement statement = connection.createStatement()) {
            statement.execute(sql);
        }
    }

    private static String table(LocalDate day) {
        return "telemetry_" + NAMED.format(day);
    }

    private static String begin(LocalDate day) {
        return "'" + day + " 00:00:00+00'";
    }
}
