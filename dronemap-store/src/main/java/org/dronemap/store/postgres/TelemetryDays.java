package org.dronemap.store.postgres;

import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.sql.DataSource;
import org.dronemap.core.history.Retention;
import org.dronemap.core.history.TelemetryPoint;
import org.dronemap.core.history.Thinning;
import org.jspecify.annotations.Nullable;
import org.postgresql.copy.CopyIn;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The tables of single days of UTC: made ahead, thinned when they are old, dropped when they are older. */
final class TelemetryDays {
    private static final Logger LOG = LoggerFactory.getLogger(TelemetryDays.class);
    private static final int DAYS_AHEAD = 2;
    private static final int ROWS_AT_ONCE = 5_000;
    private static final int LONGEST_MILLIS = 3_600_000;
    private static final String THINNED = "_thin";
    private static final Pattern NAME = Pattern.compile("telemetry_(\\d{8})(" + THINNED + ")?");
    private static final DateTimeFormatter NAMED = DateTimeFormatter.BASIC_ISO_DATE;

    private final DataSource dataSource;

    /** A day that has a table. */
    private record Day(LocalDate date, boolean thinned) {
        String table() {
            return TelemetryDays.table(date) + (thinned ? THINNED : "");
        }
    }

    TelemetryDays(DataSource dataSource) {
        this.dataSource = dataSource;
    }

    void tidy(Retention retention, Instant now) {
        try {
            LocalDate today = LocalDate.ofInstant(now, ZoneOffset.UTC);
            drop(retention.firstKept(now));
            for (LocalDate day : missing(today)) {
                make(day);
            }
            thin(retention, retention.firstFull(now));
        } catch (SQLException e) {
            throw SqlSentence.exception(e);
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
                    days.add(new Day(LocalDate.parse(name.group(1), NAMED), name.group(2) != null));
                }
            }
        }
        return days;
    }

    /** What has come for that day already, because it had no table, moves into it. */
    private void make(LocalDate day) throws SQLException {
        patiently(connection -> {
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
                patiently(connection -> execute(connection, "DROP TABLE " + day.table()));
                LOG.info("The telemetry of {} was dropped, for its time was over", day.date());
            }
        }
        patiently(connection -> {
            execute(connection, "DELETE FROM telemetry_other WHERE at < " + begin(firstKept));
            execute(connection, "DELETE FROM drone_event WHERE at < " + begin(firstKept));
        });
    }

    private void thin(Retention retention, @Nullable LocalDate firstFull) throws SQLException {
        for (Day day : days()) {
            if (firstFull != null && !day.thinned() && day.date().isBefore(firstFull)) {
                patiently(connection -> thin(connection, day, retention));
                LOG.info("The telemetry of {} was thinned", day.date());
            }
        }
    }

    private void thin(Connection connection, Day day, Retention retention) throws SQLException {
        Day thinned = new Day(day.date(), true);
        create(connection, thinned.table());
        List<TelemetryPoint> kept = new ArrayList<>();
        Thinning thinning = new Thinning(retention.thinned(), kept::add);
        String sql = "SELECT " + TelemetryRows.ALL + " FROM " + day.table() + " ORDER BY drone_id, at";
        // On a connection of its own: one cannot read and copy at the same time.
        try (Connection reading = dataSource.getConnection();
                CopyTo copy = new CopyTo(connection, thinned.table())) {
            reading.setAutoCommit(false);
            reading.setNetworkTimeout(Runnable::run, LONGEST_MILLIS);
            try (PreparedStatement statement = reading.prepareStatement(sql)) {
                statement.setFetchSize(ROWS_AT_ONCE);
                try (ResultSet result = statement.executeQuery()) {
                    while (result.next()) {
                        thinning.add(TelemetryRows.read(new Row(result)));
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
        execute(connection, "ALTER TABLE telemetry DETACH PARTITION " + day.table());
        execute(connection, "DROP TABLE " + day.table());
        attach(connection, thinned.table(), day.date());
    }

    /** A copy that ends with its block, finished or not. */
    private static final class CopyTo implements AutoCloseable {
        private final CopyIn copy;
        private final CopyBuffer out;

        CopyTo(Connection connection, String table) throws SQLException {
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

    private interface Work {
        void on(Connection connection) throws SQLException;
    }

    /** In one transaction, however long the work itself takes; but nobody is held up for long by its locks. */
    private void patiently(Work work) throws SQLException {
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
