package org.dronemap.store.postgres;

import java.sql.Connection;
import java.sql.SQLException;
import java.util.List;
import org.dronemap.core.drone.Attitude;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Gps;
import org.dronemap.core.drone.GpsFix;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.history.TelemetryColumn;
import org.dronemap.core.history.TelemetryField;
import org.dronemap.core.history.TelemetryPoint;
import org.dronemap.core.stored.StoredNames;
import org.jspecify.annotations.Nullable;
import org.postgresql.PGConnection;
import org.postgresql.copy.CopyIn;

/** Converts telemetry points to rows of PostgreSQL and back: one column for each telemetry field. */
final class TelemetryRows {
    private static final List<String> COLUMNS = TelemetryColumn.labels();
    static final String ALL = String.join(", ", COLUMNS);

    private TelemetryRows() {}

    static String column(TelemetryField field) {
        return StoredNames.of(field);
    }

    /** Begins to copy points into that table. */
    static CopyIn copyIn(Connection connection, String table) throws SQLException {
        return connection
                .unwrap(PGConnection.class)
                .getCopyAPI()
                .copyIn("COPY " + table + " (" + ALL + ") FROM STDIN WITH (FORMAT binary)");
    }

    static void write(TelemetryPoint point, CopyBuffer out) throws SQLException {
        out.row(COLUMNS.size());
        out.text(point.drone().value());
        out.time(point.at());
        out.float8(TelemetryField.LATITUDE.of(point));
        out.float8(TelemetryField.LONGITUDE.of(point));
        real(point, out, TelemetryField.ALTITUDE_AMSL, TelemetryField.ALTITUDE_ABOVE_HOME);
        real(point, out, TelemetryField.GROUND_SPEED, TelemetryField.AIR_SPEED);
        real(point, out, TelemetryField.CLIMB_RATE, TelemetryField.HEADING);
        real(point, out, TelemetryField.ROLL, TelemetryField.PITCH, TelemetryField.YAW);
        Battery battery = point.battery();
        out.integer(battery == null ? null : battery.percent());
        real(point, out, TelemetryField.BATTERY_VOLTS, TelemetryField.BATTERY_AMPS);
        Gps gps = point.gps();
        out.text(gps == null ? null : StoredNames.of(gps.fix()));
        out.integer(gps == null ? null : gps.satellites());
        real(point, out, TelemetryField.HDOP);
        out.text(StoredNames.of(point.link()));
        real(point, out, TelemetryField.LOSS_SHORT, TelemetryField.LOSS_LONG, TelemetryField.ROUND_TRIP);
        out.text(point.mode());
        out.bool(point.armed());
        out.text(point.phase() == null ? null : StoredNames.of(point.phase()));
        out.integer(point.missionItem());
        real(point, out, TelemetryField.JITTER, TelemetryField.JITTER_LONG);
    }

    private static void real(TelemetryPoint point, CopyBuffer out, TelemetryField... fields) throws SQLException {
        for (TelemetryField field : fields) {
            out.float4(field.of(point));
        }
    }

    static TelemetryPoint read(ResultRow row) throws SQLException {
        return new TelemetryPoint(
                new DroneId(row.text("drone_id")),
                row.time("at"),
                position(row),
                motion(row),
                attitude(row),
                battery(row),
                gps(row),
                row.name("link", LinkState.class),
                new LinkQuality(
                        row.number("loss_short"),
                        row.number("loss_long"),
                        row.number("round_trip"),
                        null,
                        row.number("jitter"),
                        row.number("jitter_long")),
                row.textOrNull("mode"),
                row.boolOrNull("armed"),
                row.nameOrNull("phase", FlightPhase.class),
                row.integerOrNull("mission_item"));
    }

    private static @Nullable Position position(ResultRow row) throws SQLException {
        Double latitude = row.number("latitude");
        Double longitude = row.number("longitude");
        Double amsl = row.number("altitude_amsl");
        Double aboveHome = row.number("altitude_above_home");
        Geodetic place = latitude == null || longitude == null ? null : new Geodetic(latitude, longitude);
        return place == null && amsl == null && aboveHome == null ? null : new Position(place, amsl, aboveHome);
    }

    private static @Nullable Motion motion(ResultRow row) throws SQLException {
        Double ground = row.number("ground_speed");
        Double air = row.number("air_speed");
        Double climb = row.number("climb_rate");
        Double heading = row.number("heading");
        return ground == null && air == null && climb == null && heading == null
                ? null
                : new Motion(ground, air, climb, heading);
    }

    private static @Nullable Attitude attitude(ResultRow row) throws SQLException {
        Double roll = row.number("roll");
        Double pitch = row.number("pitch");
        Double yaw = row.number("yaw");
        return roll == null || pitch == null || yaw == null ? null : new Attitude(roll, pitch, yaw);
    }

    private static @Nullable Battery battery(ResultRow row) throws SQLException {
        Integer percent = row.integerOrNull("battery_percent");
        Double volts = row.number("battery_volts");
        Double amps = row.number("battery_amps");
        return percent == null && volts == null && amps == null ? null : new Battery(percent, volts, amps);
    }

    private static @Nullable Gps gps(ResultRow row) throws SQLException {
        GpsFix fix = row.nameOrNull("gps_fix", GpsFix.class);
        return fix == null ? null : new Gps(fix, row.integerOrNull("satellites"), row.number("hdop"));
    }
}
