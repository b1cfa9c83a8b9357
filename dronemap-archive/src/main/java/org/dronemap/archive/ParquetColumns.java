package org.dronemap.archive;

import static org.apache.parquet.schema.LogicalTypeAnnotation.TimeUnit.MICROS;
import static org.apache.parquet.schema.LogicalTypeAnnotation.stringType;
import static org.apache.parquet.schema.LogicalTypeAnnotation.timestampType;

import java.util.ArrayList;
import java.util.List;
import org.apache.parquet.example.data.Group;
import org.apache.parquet.schema.MessageType;
import org.apache.parquet.schema.PrimitiveType;
import org.apache.parquet.schema.PrimitiveType.PrimitiveTypeName;
import org.apache.parquet.schema.Type;
import org.apache.parquet.schema.Types;
import org.dronemap.core.history.TelemetryColumn;
import org.jspecify.annotations.Nullable;

/** The Parquet schema of the archive's files, and the conversion of telemetry rows to it and back. */
final class ParquetColumns {
    private ParquetColumns() {}

    /** Of each file. */
    static MessageType schema() {
        return new MessageType(
                "telemetry", TelemetryColumn.ALL.stream().map(ParquetColumns::type).toList());
    }

    private static Type type(TelemetryColumn column) {
        return switch (column.kind()) {
            case TEXT -> of(column, PrimitiveTypeName.BINARY).as(stringType()).named(column.label());
            case TIME ->
                of(column, PrimitiveTypeName.INT64)
                        .as(timestampType(true, MICROS))
                        .named(column.label());
            case FLOAT8 -> of(column, PrimitiveTypeName.DOUBLE).named(column.label());
            case FLOAT4 -> of(column, PrimitiveTypeName.FLOAT).named(column.label());
            case INTEGER -> of(column, PrimitiveTypeName.INT32).named(column.label());
            case TRUTH -> of(column, PrimitiveTypeName.BOOLEAN).named(column.label());
        };
    }

    private static Types.PrimitiveBuilder<PrimitiveType> of(TelemetryColumn column, PrimitiveTypeName type) {
        return column.required() ? Types.required(type) : Types.optional(type);
    }

    /** Null: not known, and not written. */
    static void write(List<@Nullable Object> values, Group row) {
        for (int i = 0; i < TelemetryColumn.ALL.size(); i++) {
            Object value = values.get(i);
            if (value != null) {
                put(TelemetryColumn.ALL.get(i).kind(), i, value, row);
            }
        }
    }

    private static void put(TelemetryColumn.Kind kind, int field, Object value, Group row) {
        switch (kind) {
            case TEXT -> row.add(field, (String) value);
            case TIME -> row.add(field, (long) value);
            case FLOAT8 -> row.add(field, (double) value);
            case FLOAT4 -> row.add(field, (float) value);
            case INTEGER -> row.add(field, (int) value);
            case TRUTH -> row.add(field, (boolean) value);
        }
    }

    static List<@Nullable Object> read(Group row) {
        List<@Nullable Object> values = new ArrayList<>(TelemetryColumn.ALL.size());
        for (int i = 0; i < TelemetryColumn.ALL.size(); i++) {
            boolean known = row.getFieldRepetitionCount(i) > 0;
            values.add(known ? get(TelemetryColumn.ALL.get(i).kind(), i, row) : null);
        }
        return values;
    }

    private static Object get(TelemetryColumn.Kind kind, int field, Group row) {
        return switch (kind) {
            case TEXT -> row.getString(field, 0);
            case TIME -> row.getLong(field, 0);
            case FLOAT8 -> row.getDouble(field, 0);
            case FLOAT4 -> row.getFloat(field, 0);
            case INTEGER -> row.getInteger(field, 0);
            case TRUTH -> row.getBoolean(field, 0);
        };
    }
}
