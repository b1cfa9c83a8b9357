package org.dronemap.archive;

import java.io.IOException;
import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalDate;
import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.history.TelemetryColumn;
import org.jspecify.annotations.Nullable;

/** Reads telemetry rows for the archive from the server's PostgreSQL, as they were when it was opened. One thread. */
public final class DatabaseRowSource implements RowSource, AutoCloseable {
    private static final int ROWS_AT_ONCE = 5_000;
    /** What was measured late may come for so long after midnight. */
    private static final Duration LATE = Duration.ofHours(1);

    /** A batch that seemed to fail may be there twice. */
    private static final String SELECT = "SELECT DISTINCT ON (drone_id, at) "
            + String.join(", ", TelemetryColumn.labels())
            + " FROM dronemap.telemetry WHERE at >= ? AND at < ? ORDER BY drone_id, at";

    private final Connection connection;

    /** Takes the connection over, and reads one moment of the database with it. */
    public DatabaseRowSource(Connection connection) throws SQLException {
        this.connection = connection;
        connection.setReadOnly(true);
        connection.setTransactionIsolation(Connection.TRANSACTION_REPEATABLE_READ);
        connection.setAutoCommit(false);
    }

    /** Days with rows that are over, oldest first. */
    public List<LocalDate> finished(Instant now) throws SQLException {
        LocalDate today = LocalDate.ofInstant(now.minus(LATE), ZoneOffset.UTC);
        List<LocalDate> days = new ArrayList<>();
        LocalDate oldest = oldest();
        for (LocalDate day = oldest; day != null && day.isBefore(today); day = day.plusDays(1)) {
            days.add(day);
        }
        return days;
    }

    private @Nullable LocalDate oldest() throws SQLException {
        try (Statement statement = connection.createStatement();
                ResultSet result = statement.executeQuery("SELECT min(at) FROM dronemap.telemetry")) {
            result.next();
            OffsetDateTime first = result.getObject(1, OffsetDateTime.class);
            return first == null ? null : LocalDate.ofInstant(first.toInstant(), ZoneOffset.UTC);
        }
    }

    @Override
    public void of(LocalDate day, RowConsumer taker) throws IOException {
        try (PreparedStatement statement = connection.prepareStatement(SELECT)) {
            statement.setObject(1, day.atStartOfDay().atOffset(ZoneOffset.UTC));
            statement.setObject(2, day.plusDays(1).atStartOfDay().atOffset(ZoneOffset.UTC));
            statement.setFetchSize(ROWS_AT_ONCE);
            try (ResultSet result = statement.executeQuery()) {
                while (result.next()) {
                    taker.row(values(result));
                }
            }
        } catch (SQLException e) {
            throw new IOException("The rows of " + day + " cannot be read: " + e.getMessage(), e);
        }
    }

    private static List<@Nullable Object> values(ResultSet result) throws SQLException {
        List<@Nullable Object> values = new ArrayList<>(TelemetryColumn.ALL.size());
        for (TelemetryColumn column : TelemetryColumn.ALL) {
            values.add(value(result, values.size() + 1, column.kind()));
        }
        return values;
    }

    private static @Nullable Object value(ResultSet result, int place, TelemetryColumn.Kind kind) throws SQLException {
        return switch (kind) {
            case TEXT -> result.getString(place);
            case TIME ->
                ChronoUnit.MICROS.between(
                        Instant.EPOCH,
                        result.getObject(place, OffsetDateTime.class).toInstant());
            case FLOAT8 -> known(result, result.getDouble(place));
            case FLOAT4 -> known(result, result.getFloat(place));
            case INTEGER -> known(result, result.getInt(place));
            case TRUTH -> known(result, result.getBoolean(place));
        };
    }

    private static @Nullable Object known(ResultSet result, Object value) throws SQLException {
        return result.wasNull() ? null : value;
    }

    @Override
    public void close() throws SQLException {
        connection.close();
    }
}
