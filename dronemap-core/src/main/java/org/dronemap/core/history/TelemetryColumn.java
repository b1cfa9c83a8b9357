package org.dronemap.core.history;

import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import org.dronemap.core.stored.Stored;
import org.dronemap.core.stored.StoredNames;
import org.jspecify.annotations.Nullable;

/** Columns of telemetry tables, the same in the database, the archive and exported files. */
@Stored(
        names = "drone_id at latitude longitude altitude_amsl altitude_above_home ground_speed "
                + "air_speed climb_rate heading roll pitch yaw battery_percent battery_volts "
                + "battery_amps gps_fix satellites hdop link loss_short loss_long round_trip mode armed "
                + "phase mission_item jitter jitter_long")
public enum TelemetryColumn {
    DRONE_ID(Kind.TEXT, true),
    AT(Kind.TIME, true),
    LATITUDE(TelemetryField.LATITUDE, Kind.FLOAT8),
    LONGITUDE(TelemetryField.LONGITUDE, Kind.FLOAT8),
    ALTITUDE_AMSL(TelemetryField.ALTITUDE_AMSL, Kind.FLOAT4),
    ALTITUDE_ABOVE_HOME(TelemetryField.ALTITUDE_ABOVE_HOME, Kind.FLOAT4),
    GROUND_SPEED(TelemetryField.GROUND_SPEED, Kind.FLOAT4),
    AIR_SPEED(TelemetryField.AIR_SPEED, Kind.FLOAT4),
    CLIMB_RATE(TelemetryField.CLIMB_RATE, Kind.FLOAT4),
    HEADING(TelemetryField.HEADING, Kind.FLOAT4),
    ROLL(TelemetryField.ROLL, Kind.FLOAT4),
    PITCH(TelemetryField.PITCH, Kind.FLOAT4),
    YAW(TelemetryField.YAW, Kind.FLOAT4),
    BATTERY_PERCENT(TelemetryField.BATTERY_PERCENT, Kind.INTEGER),
    BATTERY_VOLTS(TelemetryField.BATTERY_VOLTS, Kind.FLOAT4),
    BATTERY_AMPS(TelemetryField.BATTERY_AMPS, Kind.FLOAT4),
    GPS_FIX(Kind.TEXT, false),
    SATELLITES(TelemetryField.SATELLITES, Kind.INTEGER),
    HDOP(TelemetryField.HDOP, Kind.FLOAT4),
    LINK(Kind.TEXT, true),
    LOSS_SHORT(TelemetryField.LOSS_SHORT, Kind.FLOAT4),
    LOSS_LONG(TelemetryField.LOSS_LONG, Kind.FLOAT4),
    ROUND_TRIP(TelemetryField.ROUND_TRIP, Kind.FLOAT4),
    MODE(Kind.TEXT, false),
    ARMED(Kind.TRUTH, false),
    PHASE(Kind.TEXT, false),
    MISSION_ITEM(TelemetryField.MISSION_ITEM, Kind.INTEGER),
    JITTER(TelemetryField.JITTER, Kind.FLOAT4),
    JITTER_LONG(TelemetryField.JITTER_LONG, Kind.FLOAT4);

    /** In this order. */
    public static final List<TelemetryColumn> ALL = List.of(values());

    private final @Nullable TelemetryField field;
    private final Kind kind;
    private final boolean required;

    /** Value type of a telemetry column, with its Java type in brackets. */
    public enum Kind {
        /** (String) */
        TEXT,
        /** Microseconds since 1970, UTC (Long) */
        TIME,
        /** (Double) */
        FLOAT8,
        /** (Float) */
        FLOAT4,
        /** (Integer) */
        INTEGER,
        /** (Boolean) */
        TRUTH
    }

    TelemetryColumn(Kind kind, boolean required) {
        this.field = null;
        this.kind = kind;
        this.required = required;
    }

    /** Places are kept as they are, other numbers to seven digits. */
    TelemetryColumn(TelemetryField field, Kind kind) {
        this.field = field;
        this.kind = kind;
        this.required = false;
    }

    public String label() {
        return StoredNames.of(this);
    }

    /** All labels, in this order. */
    public static List<String> labels() {
        return ALL.stream().map(TelemetryColumn::label).toList();
    }

    public Kind kind() {
        return kind;
    }

    /** Always known. */
    public boolean required() {
        return required;
    }

    /** As {@link #kind} says; null: not known. */
    public @Nullable Object of(TelemetryPoint point) {
        return field == null ? fact(point) : number(field.of(point));
    }

    private @Nullable Object number(@Nullable Double number) {
        if (number == null) {
            return null;
        }
        return switch (kind) {
            case FLOAT4 -> number.floatValue();
            case INTEGER -> number.intValue();
            default -> number;
        };
    }

    private @Nullable Object fact(TelemetryPoint point) {
        return switch (this) {
            case DRONE_ID -> point.drone().value();
            case AT -> ChronoUnit.MICROS.between(Instant.EPOCH, point.at());
            case GPS_FIX ->
                point.gps() == null ? null : StoredNames.of(point.gps().fix());
            case LINK -> StoredNames.of(point.link());
            case MODE -> point.mode();
            case ARMED -> point.armed();
            default -> point.phase() == null ? null : StoredNames.of(point.phase());
        };
    }
}
