package org.dronemap.store.postgres;

import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.sql.DataSource;
import org.dronemap.core.audit.AuditEntry;
import org.dronemap.core.audit.AuditRecord;
import org.dronemap.core.audit.AuditedCall;
import org.dronemap.core.stored.StoredNames;
import org.dronemap.store.StoreException;
import org.dronemap.store.StoredInstant;
import org.jspecify.annotations.Nullable;

/**
 * Runs SQL statements on a connection pool, each a transaction of its own, durable when it returns. The first change of
 * a call takes the call's record into its transaction. Thread-safe.
 */
final class SqlTransactions {
    /** Makes an object of the row that the result stands on. */
    interface RowReader<T> {
        T read(ResultRow row) throws SQLException;
    }

    private final DataSource dataSource;
    private final AuditLedger ledger;

    SqlTransactions(DataSource dataSource, AuditLedger ledger) {
        this.dataSource = dataSource;
        this.ledger = ledger;
    }

    <T> List<T> list(String sql, RowReader<T> reader, @Nullable Object... arguments) {
        try (Connection connection = dataSource.getConnection();
                PreparedStatement statement = prepare(connection, sql, arguments);
                ResultSet result = statement.executeQuery()) {
            List<T> found = new ArrayList<>();
            while (result.next()) {
                found.add(reader.read(new ResultRow(result)));
            }
            return List.copyOf(found);
        } catch (SQLException e) {
            throw SqlErrorMessages.exception(e);
        }
    }

    <T> Optional<T> one(String sql, RowReader<T> reader, @Nullable Object... arguments) {
        List<T> found = list(sql, reader, arguments);
        if (found.size() > 1) {
            throw new StoreException("more than one row where one was expected: " + sql);
        }
        return found.stream().findFirst();
    }

    /** How many rows it changed. */
    int update(String sql, @Nullable Object... arguments) {
        Optional<AuditedCall> call = ledger.isOpen() ? AuditedCall.current() : Optional.empty();
        return call.flatMap(activity -> activity.claim().map(entry -> recorded(activity, entry, sql, arguments)))
                .orElseGet(() -> alone(sql, arguments));
    }

    private int recorded(AuditedCall call, AuditEntry entry, String sql, @Nullable Object... arguments) {
        AuditRecord record = null;
        try {
            AuditLedger.WriteResult written = ledger.write(entry, connection -> update(connection, sql, arguments));
            record = written.record();
            return written.rows();
        } finally {
            if (record == null) {
                call.released();
            } else {
                call.written(record.sequence());
            }
        }
    }

    private int alone(String sql, @Nullable Object... arguments) {
        try (Connection connection = dataSource.getConnection()) {
            int rows = update(connection, sql, arguments);
            ledger.unauditedWritten(rows);
            return rows;
        } catch (SQLException e) {
            ledger.failed(e);
            throw SqlErrorMessages.exception(e);
        }
    }

    private static int update(Connection connection, String sql, @Nullable Object... arguments) throws SQLException {
        try (PreparedStatement statement = prepare(connection, sql, arguments)) {
            return statement.executeUpdate();
        }
    }

    static PreparedStatement prepare(Connection connection, String sql, @Nullable Object... arguments)
            throws SQLException {
        PreparedStatement statement = connection.prepareStatement(sql);
        try {
            set(statement, arguments);
            return statement;
        } catch (SQLException | RuntimeException e) {
            statement.close();
            throw e;
        }
    }

    static void set(PreparedStatement statement, @Nullable Object... arguments) throws SQLException {
        for (int i = 0; i < arguments.length; i++) {
            statement.setObject(i + 1, stored(arguments[i]));
        }
    }

    private static @Nullable Object stored(@Nullable Object argument) {
        if (argument instanceof Instant time) {
            return StoredInstant.of(time).atOffset(ZoneOffset.UTC);
        }
        if (argument instanceof Enum<?> constant) {
            return StoredNames.of(constant);
        }
        // PostgreSQL's text cannot hold the zero character.
        return argument instanceof String text ? text.replace('\0', '\uFFFD') : argument;
    }
}
