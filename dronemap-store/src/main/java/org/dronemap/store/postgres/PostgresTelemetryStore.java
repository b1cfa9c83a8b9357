package org.dronemap.store.postgres;

import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import javax.sql.DataSource;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.history.EventLoss;
import org.dronemap.core.history.EventPage;
import org.dronemap.core.history.HistoryEvent;
import org.dronemap.core.history.Retention;
import org.dronemap.core.history.SeriesQuery;
import org.dronemap.core.history.SeriesSlot;
import org.dronemap.core.history.TelemetryField;
import org.dronemap.core.history.TelemetryPoint;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.core.history.TimeRange;
import org.jspecify.annotations.Nullable;

/** Stores telemetry and drones' events in PostgreSQL, telemetry in a table for each day. Thread-safe. */
public final class PostgresTelemetryStore implements TelemetryStore {
    private static final int ROWS_AT_ONCE = 2_000;

    private final DataSource dataSource;
    private final DayWriteGuard gate = new DayWriteGuard();
    private final TelemetryDayTables days;
    private final PostgresEventSeries series;

    PostgresTelemetryStore(DataSource dataSource) {
        this.dataSource = dataSource;
        this.days = new TelemetryDayTables(dataSource, gate);
        this.series = new PostgresEventSeries(dataSource);
    }

    @Override
    public void append(List<TelemetryPoint> points, List<HistoryEvent> events, @Nullable EventLoss lost) {
        try {
            gate.write(points, () -> write(points, events, lost));
        } catch (SQLException e) {
            throw SqlErrorMessages.exception(e);
        }
    }

    private void write(List<TelemetryPoint> points, List<HistoryEvent> events, @Nullable EventLoss lost)
            throws SQLException {
        try (Connection connection = dataSource.getConnection()) {
            connection.setAutoCommit(false);
            try {
                if (!points.isEmpty()) {
                    CopyBuffer out = new CopyBuffer(TelemetryRows.copyIn(connection, "telemetry"));
                    for (TelemetryPoint point : points) {
                        TelemetryRows.write(point, out);
                    }
                    out.end();
                }
                PostgresEventSeries.append(connection, events, lost);
                connection.commit();
            } catch (SQLException | RuntimeException e) {
                connection.rollback();
                throw e;
            }
        }
    }

    @Override
    public void points(DroneId drone, TimeRange span, Consumer<TelemetryPoint> each) {
        String sql =
                "SELECT " + TelemetryRows.ALL + " FROM telemetry WHERE drone_id = ? AND at >= ? AND at < ? ORDER BY at";
        try (Connection connection = dataSource.getConnection()) {
            // The driver reads in portions only within a transaction.
            connection.setAutoCommit(false);
            try (PreparedStatement statement = SqlTransactions.prepare(
                    connection, sql, drone.value(), ceiling(span.from()), ceiling(span.until()))) {
                statement.setFetchSize(ROWS_AT_ONCE);
                eachOnce(statement, each);
            } finally {
                connection.rollback();
            }
        } catch (SQLException e) {
            throw SqlErrorMessages.exception(e);
        }
    }

    private static void eachOnce(PreparedStatement statement, Consumer<TelemetryPoint> each) throws SQLException {
        try (ResultSet result = statement.executeQuery()) {
            Instant before = null;
            while (result.next()) {
                TelemetryPoint point = TelemetryRows.read(new ResultRow(result));
                if (!point.at().equals(before)) {
                    each.accept(point);
                }
                before = point.at();
            }
        }
    }

    @Override
    public List<SeriesSlot> series(SeriesQuery query) {
        String extents = query.fields().stream()
                .map(TelemetryRows::column)
                .map(column -> ", min(" + column + "), max(" + column + ")")
                .collect(Collectors.joining());
        String sql = "SELECT min(at)" + extents
                + " FROM telemetry WHERE drone_id = ? AND at >= ? AND at < ?"
                + " GROUP BY date_bin(make_interval(secs => ?), at, ?) ORDER BY 1";
        try (Connection connection = dataSource.getConnection();
                PreparedStatement statement = SqlTransactions.prepare(
                        connection,
                        sql,
                        query.drone().value(),
                        ceiling(query.span().from()),
                        ceiling(query.span().until()),
                        query.slot().toNanos() / 1e9,
                        query.span().from());
                ResultSet result = statement.executeQuery()) {
            List<SeriesSlot> slots = new ArrayList<>();
            while (result.next()) {
                slots.add(slot(new ResultRow(result), query.fields()));
            }
            return List.copyOf(slots);
        } catch (SQLException e) {
            throw SqlErrorMessages.exception(e);
        }
    }

    private static SeriesSlot slot(ResultRow row, List<TelemetryField> fields) throws SQLException {
        List<SeriesSlot.@Nullable Extent> extents = new ArrayList<>(fields.size());
        for (int i = 0; i < fields.size(); i++) {
            Double least = row.number(2 + 2 * i);
            Double most = row.number(3 + 2 * i);
            extents.add(least == null || most == null ? null : new SeriesSlot.Extent(least, most));
        }
        return new SeriesSlot(row.time(1), extents);
    }

    @Override
    public List<HistoryEvent> events(DroneId drone, TimeRange span, int limit) {
        String sql = "SELECT * FROM drone_event WHERE drone_id = ? AND at >= ? AND at < ? ORDER BY at, id LIMIT ?";
        try (Connection connection = dataSource.getConnection();
                PreparedStatement statement = SqlTransactions.prepare(
                        connection, sql, drone.value(), ceiling(span.from()), ceiling(span.until()), limit);
                ResultSet result = statement.executeQuery()) {
            List<HistoryEvent> events = new ArrayList<>();
            while (result.next()) {
                events.add(PostgresEventSeries.event(new ResultRow(result)));
            }
            return List.copyOf(events);
        } catch (SQLException e) {
            throw SqlErrorMessages.exception(e);
        }
    }

    @Override
    public void openEvents(Instant now) {
        try {
            series.open(now);
        } catch (SQLException e) {
            throw SqlErrorMessages.exception(e);
        }
    }

    @Override
    public void closeEvents() {
        try {
            series.close();
        } catch (SQLException e) {
            throw SqlErrorMessages.exception(e);
        }
    }

    @Override
    public EventPage eventsAfter(long number, int limit) {
        try {
            return series.after(number, limit);
        } catch (SQLException e) {
            throw SqlErrorMessages.exception(e);
        }
    }

    /** Kept times are cut to the microsecond: one that is asked for more finely lies after what is kept of it. */
    private static Instant ceiling(Instant time) {
        return time.plusNanos(999);
    }

    @Override
    public void tidy(Retention retention, Instant now) {
        days.tidy(retention, now);
    }

    @Override
    public String server() {
        try (Connection connection = dataSource.getConnection()) {
            return "PostgreSQL " + connection.getMetaData().getDatabaseProductVersion();
        } catch (SQLException e) {
            throw SqlErrorMessages.exception(e);
        }
    }
}
