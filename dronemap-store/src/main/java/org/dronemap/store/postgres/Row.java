package org.dronemap.store.postgres;

import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Instant;
import java.time.OffsetDateTime;
import org.jspecify.annotations.Nullable;

/** The columns of the row that a result stands on, by name and in the types of the core. */
record Row(ResultSet result) {
    String text(String column) throws SQLException {
        String value = result.getString(column);
        if (value == null) {
            throw new SQLException("column " + column + " is null");
        }
        return value;
    }

    @Nullable
    String textOrNull(String column) throws SQLException {
        return result.getString(column);
    }

    int integer(String column) throws SQLException {
        return result.getInt(column);
    }

    long longInteger(String column) throws SQLException {
        return result.getLong(column);
    }

    @Nullable
    Integer integerOrNull(String column) throws SQLException {
        return result.getObject(column, Integer.class);
    }

    @Nullable
    Long longOrNull(String column) throws SQLException {
        return result.getObject(column, Long.class);
    }

    boolean bool(String column) throws SQLException {
        return result.getBoolean(column);
    }

    Instant time(String column) throws SQLException {
        Instant value = timeOrNull(column);
        if (value == null) {
            throw new SQLException("column " + column + " is null");
        }
        return value;
    }

    @Nullable
    Instant timeOrNull(String column) throws SQLException {
        OffsetDateTime value = result.getObject(column, OffsetDateTime.class);
        return value == null ? null : value.toInstant();
    }

    <E extends Enum<E>> E name(String column, Class<E> type) throws SQLException {
        return Enum.valueOf(type, text(column));
    }
}
