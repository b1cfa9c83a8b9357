package org.dronemap.store.postgres;

import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import javax.sql.DataSource;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.history.EventGap;
import org.dronemap.core.history.EventLoss;
import org.dronemap.core.history.EventPage;
import org.dronemap.core.history.EventSeries;
import org.dronemap.core.history.HistoryEvent;
import org.dronemap.core.history.NumberedEvent;
import org.jspecify.annotations.Nullable;

/** Numbers drones' events in PostgreSQL, and reads them by their numbers. Thread-safe. */
final class PostgresEventSeries {
    /** Whoever gives numbers holds it to the end of the transaction, so that they come to be seen in their order. */
    private static final String LOCK = "SELECT id FROM event_series FOR UPDATE";

    /** Numbers given by a copy of this database are below the time, as long as fewer than a million events come a second. */
    private static final String RAISE = """
            SELECT setval(pg_get_serial_sequence('drone_event', 'id'), greatest(?,
                nextval(pg_get_serial_sequence('drone_event', 'id')),
                (SELECT max(id) FROM drone_event), (SELECT max(number) FROM event_gap)))""";

    private static final String GAP = "INSERT INTO event_gap (number, cause, from_at, until_at, lost)"
            + " VALUES (nextval(pg_get_serial_sequence('drone_event', 'id')), ?, ?, ?, ?)";

    private static final String MARK_GAP = """
            INSERT INTO event_gap (number, cause, from_at, until_at)
            SELECT nextval(pg_get_serial_sequence('drone_event', 'id')), ?,
                least(?, greatest(opened_at, (SELECT at FROM drone_event ORDER BY id DESC LIMIT 1))), ?
            FROM event_series WHERE opened_at IS NOT NULL""";

    private static final String STATE = """
            SELECT id, expired, expired_before, greatest(expired,
                (SELECT max(id) FROM drone_event), (SELECT max(number) FROM event_gap)) AS newest
            FROM event_series""";

    private static final long GREATEST_FLOOR = 1L << 52;

    private final DataSource dataSource;

    private interface DatabaseWork<T> {
        T on(Connection connection) throws SQLException;
    }

    PostgresEventSeries(DataSource dataSource) {
        this.dataSource = dataSource;
    }

    /** Within the caller's transaction. */
    static void append(Connection connection, List<HistoryEvent> events, @Nullable EventLoss lost) throws SQLException {
        if (events.isEmpty() && lost == null) {
            return;
        }
        execute(connection, LOCK);
        if (lost != null) {
            execute(connection, GAP, EventGap.Cause.NOT_WRITTEN, lost.from(), lost.until(), lost.count());
        }
        try (PreparedStatement statement = connection.prepareStatement("""
                INSERT INTO drone_event (drone_id, at, kind, text, severity, done_by, command_id, result, reason)
                VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)""")) {
            for (HistoryEvent event : events) {
                SqlTransactions.set(
                        statement,
                        event.drone().value(),
                        event.at(),
                        event.kind(),
                        event.text(),
                        event.severity(),
                        event.by(),
                        event.command(),
                        event.result(),
                        event.reason());
                statement.addBatch();
            }
            statement.executeBatch();
        }
    }

    void open(Instant now) throws SQLException {
        long floor = Math.min(now.toEpochMilli() * 1_000, GREATEST_FLOOR);
        boolean unused = inTransaction(connection -> {
            execute(connection, LOCK);
            execute(connection, RAISE, floor);
            execute(connection, MARK_GAP, EventGap.Cause.SERVER_ENDED, now, now);
            return execute(connection, "UPDATE event_series SET opened_at = ?", now);
        });
    }

    void close() throws SQLException {
        boolean unused = inTransaction(connection -> execute(connection, "UPDATE event_series SET opened_at = NULL"));
    }

    /** Drops what is older, within the caller's transaction. */
    static void drop(Connection connection, Instant kept) throws SQLException {
        try (PreparedStatement statement = SqlTransactions.prepare(connection, """
                        WITH events AS (DELETE FROM drone_event WHERE at < ? RETURNING id),
                            gaps AS (DELETE FROM event_gap WHERE until_at < ? RETURNING number)
                        SELECT greatest((SELECT max(id) FROM events), (SELECT max(number) FROM gaps)) AS highest""", kept, kept);
                ResultSet result = statement.executeQuery()) {
            result.next();
            long highest = result.getLong("highest");
            if (!result.wasNull()) {
                boolean unused = execute(
                        connection,
                        "UPDATE event_series SET expired = greatest(expired, ?), expired_before = ?",
                        highest,
                        kept);
            }
        }
    }

    EventPage after(long number, int limit) throws SQLException {
        return inTransaction(connection -> {
            // State, events and gaps of one moment.
            execute(connection, "SET TRANSACTION ISOLATION LEVEL REPEATABLE READ, READ ONLY");
            List<EventSeries> series = list(connection, STATE, PostgresEventSeries::state);
            return EventPage.of(
                    series.get(0),
                    number,
                    limit,
                    list(
                            connection,
                            "SELECT * FROM drone_event WHERE id > ? ORDER BY id LIMIT ?",
                            row -> new NumberedEvent(row.longInteger("id"), event(row)),
                            number,
                            limit),
                    list(
                            connection,
                            "SELECT * FROM event_gap WHERE number > ? ORDER BY number LIMIT ?",
                            PostgresEventSeries::gap,
                            number,
                            limit));
        });
    }

    static HistoryEvent event(ResultRow row) throws SQLException {
        return new HistoryEvent(
                new DroneId(row.text("drone_id")),
                row.time("at"),
                row.name("kind", HistoryEvent.Kind.class),
                row.text("text"),
                row.nameOrNull("severity", Severity.class),
                row.textOrNull("done_by"),
                row.textOrNull("command_id"),
                row.textOrNull("result"),
                row.textOrNull("reason"));
    }

    private static EventSeries state(ResultRow row) throws SQLException {
        return new EventSeries(
                row.text("id"),
                row.longInteger("newest"),
                row.longInteger("expired"),
                row.timeOrNull("expired_before"));
    }

    private static EventGap gap(ResultRow row) throws SQLException {
        return new EventGap(
                row.longInteger("number"),
                row.name("cause", EventGap.Cause.class),
                row.timeOrNull("from_at"),
                row.time("until_at"),
                row.longOrNull("lost"));
    }

    private static <T> List<T> list(
            Connection connection, String sql, SqlTransactions.RowReader<T> reader, @Nullable Object... arguments)
            throws SQLException {
        try (PreparedStatement statement = SqlTransactions.prepare(connection, sql, arguments);
                ResultSet result = statement.executeQuery()) {
            List<T> found = new ArrayList<>();
            while (result.next()) {
                found.add(reader.read(new ResultRow(result)));
            }
            return found;
        }
    }

    private static boolean execute(Connection connection, String sql, @Nullable Object... arguments)
            throws SQLException {
        try (PreparedStatement statement = SqlTransactions.prepare(connection, sql, arguments)) {
            return statement.execute();
        }
    }

    private <T> T inTransaction(DatabaseWork<T> work) throws SQLException {
        try (Connection connection = dataSource.getConnection()) {
            connection.setAutoCommit(false);
            try {
                T done = work.on(connection);
                connection.commit();
                return done;
            } catch (SQLException | RuntimeException e) {
                connection.rollback();
                throw e;
            }
        }
    }
}
