package org.dronemap.archive;

import static org.apache.parquet.schema.LogicalTypeAnnotation.TimeUnit.MICROS;
import static org.apache.parquet.schema.LogicalTypeAnnotation.stringType;
import static org.apache.parquet.schema.LogicalTypeAnnotation.timestampType;

import java.util.List;
import org.apache.parquet.example.data.Group;
import org.apache.parquet.schema.MessageType;
import org.apache.parquet.schema.PrimitiveType;
import org.apache.parquet.schema.PrimitiveType.PrimitiveTypeName;
import org.apache.parquet.schema.Type;
import org.apache.parquet.schema.Types;
import org.jspecify.annotations.Nullable;

/** A column of the archive: the same in every file, and named as in the database. */
record Column(String name, Kind kind, boolean required) {
    /** In the order of the files; to change it is to make a new kind of archive. */
    static final List<Column> ALL = List.of(
            required("drone_id", Kind.TEXT),
            required("at", Kind.TIME),
            optional("latitude", Kind.FLOAT8),
            optional("longitude", Kind.FLOAT8),
            optional("altitude_amsl", Kind.FLOAT4),
            optional("altitude_above_home", Kind.FLOAT4),
            optional("ground_speed", Kind.FLOAT4),
            optional("air_speed", Kind.FLOAT4),
            optional("climb_rate", Kind.FLOAT4),
            optional("heading", Kind.FLOAT4),
            optional("roll", Kind.FLOAT4),
            optional("pitch", Kind.FLOAT4),
            optional("yaw", Kind.FLOAT4),
            optional("battery_percent", Kind.INTEGER),
            optional("battery_volts", Kind.FLOAT4),
            optional("battery_amps", Kind.FLOAT4),
            optional("gps_fix", Kind.TEXT),
            optional("satellites", Kind.INTEGER),
            optional("hdop", Kind.FLOAT4),
            required("link", Kind.TEXT),
            optional("loss_short", Kind.FLOAT4),
            optional("loss_long", Kind.FLOAT4),
            optional("round_trip", Kind.FLOAT4),
            optional("mode", Kind.TEXT),
            optional("armed", Kind.TRUTH),
            optional("phase", Kind.TEXT),
            optional("mission_item", Kind.INTEGER));

    /** What stands in a column: the type in Java in brackets. */
    enum Kind {
        /** (String) */
        TEXT(PrimitiveTypeName.BINARY) {
            @Override
            void put(Group row, int field, Object value) {
                row.add(field, (String) value);
            }

            @Override
            Object get(Group row, int field) {
                return row.getString(field, 0);
            }
        },
        /** Microseconds since 1970, UTC (Long) */
        TIME(PrimitiveTypeName.INT64) {
            @Override
            void put(Group row, int field, Object value) {
                row.add(field, (long) value);
            }

            @Override
            Object get(Group row, int field) {
                return row.getLong(field, 0);
            }
        },
        /** (Double) */
        FLOAT8(PrimitiveTypeName.DOUBLE) {
            @Override
            void put(Group row, int field, Object value) {
                row.add(field, (double) value);
            }

            @Override
            Object get(Group row, int field) {
                return row.getDouble(field, 0);
            }
        },
        /** (Float) */
        FLOAT4(PrimitiveTypeName.FLOAT) {
            @Override
            void put(Group row, int field, Object value) {
                row.add(field, (float) value);
            }

            @Override
            Object get(Group row, int field) {
                return row.getFloat(field, 0);
            }
        },
        /** (Integer) */
        INTEGER(PrimitiveTypeName.INT32) {
            @Override
            void put(Group row, int field, Object value) {
                row.add(field, (int) value);
            }

            @Override
            Object get(Group row, int field) {
                return row.getInteger(field, 0);
            }
        },
        /** (Boolean) */
        TRUTH(PrimitiveTypeName.BOOLEAN) {
            @Override
            void put(Group row, int field, Object value) {
                row.add(field, (boolean) value);
            }

            @Override
            Object get(Group row, int field) {
                return row.getBoolean(field, 0);
            }
        };

        private final PrimitiveTypeName type;

        Kind(PrimitiveTypeName type) {
            this.type = type;
        }

        abstract void put(Group row, int field, Object value);

        abstract Object get(Group row, int field);
    }

    private static Column required(String name, Kind kind) {
        return new Column(name, kind, true);
    }

    private static Column optional(String name, Kind kind) {
        return new Column(name, kind, false);
    }

    /** Of each file. */
    static MessageType schema() {
        return new MessageType("telemetry", ALL.stream().map(Column::type).toList());
    }

    private Type type() {
        Types.PrimitiveBuilder<PrimitiveType> type = required ? Types.required(kind.type) : Types.optional(kind.type);
        return switch (kind) {
            case TEXT -> type.as(stringType()).named(name);
            case TIME -> type.as(timestampType(true, MICROS)).named(name);
            default -> type.named(name);
        };
    }

    /** Null: not known, and not written. */
    static void write(List<@Nullable Object> values, Group row) {
        for (int i = 0; i < ALL.size(); i++) {
            Object value = values.get(i);
            if (value != null) {
                ALL.get(i).kind.put(row, i, value);
            }
        }
    }

    static @Nullable Object read(int field, Group row) {
        return row.getFieldRepetitionCount(field) == 0
                ? null
                : ALL.get(field).kind.get(row, field);
    }
}
