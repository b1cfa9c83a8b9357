package org.dronemap.store.postgres;

import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.util.List;
import org.dronemap.core.stored.StoredNames;
import org.jspecify.annotations.Nullable;

/** Reads the columns of a query result's current row, by name and in the types of the core. */
record ResultRow(ResultSet result) {
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

    /** In the digits that are kept, so that a short number comes back as it was. */
    @Nullable
    Double number(String column) throws SQLException {
        return number(result.getObject(column));
    }

    @Nullable
    Double number(int place) throws SQLException {
        return number(result.getObject(place));
    }

    private static @Nullable Double number(@Nullable Object value) {
        if (value instanceof Float single) {
            return Double.valueOf(single.toString());
        }
        return value == null ? null : (Double) ((Number) value).doubleValue();
    }

    @Nullable
    Boolean boolOrNull(String column) throws SQLException {
        return result.getObject(column, Boolean.class);
    }

    List<String> texts(String column) throws SQLException {
        return List.of((String[]) result.getArray(column).getArray());
    }

    double float8(String column) throws SQLException {
        return result.getDouble(column);
    }

    boolean bool(String column) throws SQLException {
        return result.getBoolean(column);
    }

    Instant time(int place) throws SQLException {
        return result.getObject(place, OffsetDateTime.class).toInstant();
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
        return StoredNames.constant(type, text(column));
    }

    <E extends Enum<E>> @Nullable E nameOrNull(String column, Class<E> type) throws SQLException {
        String name = textOrNull(column);
        return name == null ? null : StoredNames.constant(type, name);
    }
}
