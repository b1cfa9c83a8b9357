package org.dronemap.store.mongo;

import java.time.Instant;
import java.time.temporal.ChronoField;
import java.util.Date;
import org.bson.Document;
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
import org.dronemap.core.history.TelemetryField;
import org.dronemap.core.history.TelemetryPoint;
import org.dronemap.core.stored.StoredNames;
import org.jspecify.annotations.Nullable;

/**
 * Converts telemetry points to MongoDB documents and back: a member for each number that is known. MongoDB's times have
 * milliseconds: the microseconds stand beside them.
 */
final class PointDocument {
    static final String DRONE = "drone";
    static final String AT = "at";
    static final String MICROS = "us";

    private PointDocument() {}

    static String member(TelemetryField field) {
        return StoredNames.of(field);
    }

    static int micros(Instant time) {
        return time.get(ChronoField.MICRO_OF_SECOND) % 1_000;
    }

    static Instant time(Document document) {
        Integer micros = document.getInteger(MICROS);
        return document.getDate(AT).toInstant().plusNanos((micros == null ? 0 : micros) * 1_000L);
    }

    static Document of(TelemetryPoint point) {
        Document document = new Document(DRONE, point.drone().value())
                .append(AT, Date.from(point.at()))
                .append(MICROS, micros(point.at()))
                .append("link", StoredNames.of(point.link()));
        for (TelemetryField field : TelemetryField.values()) {
            put(document, member(field), field.of(point));
        }
        Gps gps = point.gps();
        put(document, "gps_fix", gps == null ? null : StoredNames.of(gps.fix()));
        put(document, "mode", point.mode());
        put(document, "armed", point.armed());
        put(document, "phase", point.phase() == null ? null : StoredNames.of(point.phase()));
        return document;
    }

    private static void put(Document document, String member, @Nullable Object value) {
        if (value != null) {
            document.append(member, value);
        }
    }

    static TelemetryPoint read(Document document) {
        String phase = document.getString("phase");
        Double item = number(document, TelemetryField.MISSION_ITEM);
        return new TelemetryPoint(
                new DroneId(document.getString(DRONE)),
                time(document),
                position(document),
                motion(document),
                attitude(document),
                battery(document),
                gps(document),
                StoredNames.constant(LinkState.class, document.getString("link")),
                new LinkQuality(
                        number(document, TelemetryField.LOSS_SHORT),
                        number(document, TelemetryField.LOSS_LONG),
                        number(document, TelemetryField.ROUND_TRIP),
                        null,
                        number(document, TelemetryField.JITTER),
                        number(document, TelemetryField.JITTER_LONG)),
                document.getString("mode"),
                document.getBoolean("armed"),
                phase == null ? null : StoredNames.constant(FlightPhase.class, phase),
                item == null ? null : (Integer) item.intValue());
    }

    private static @Nullable Position position(Document document) {
        Double latitude = number(document, TelemetryField.LATITUDE);
        Double longitude = number(document, TelemetryField.LONGITUDE);
        Double amsl = number(document, TelemetryField.ALTITUDE_AMSL);
        Double aboveHome = number(document, TelemetryField.ALTITUDE_ABOVE_HOME);
        Geodetic place = latitude == null || longitude == null ? null : new Geodetic(latitude, longitude);
        return place == null && amsl == null && aboveHome == null ? null : new Position(place, amsl, aboveHome);
    }

    private static @Nullable Motion motion(Document document) {
        Double ground = number(document, TelemetryField.GROUND_SPEED);
        Double air = number(document, TelemetryField.AIR_SPEED);
        Double climb = number(document, TelemetryField.CLIMB_RATE);
        Double heading = number(document, TelemetryField.HEADING);
        return ground == null && air == null && climb == null && heading == null
                ? null
                : new Motion(ground, air, climb, heading);
    }

    private static @Nullable Attitude attitude(Document document) {
        Double roll = number(document, TelemetryField.ROLL);
        Double pitch = number(document, TelemetryField.PITCH);
        Double yaw = number(document, TelemetryField.YAW);
        return roll == null || pitch == null || yaw == null ? null : new Attitude(roll, pitch, yaw);
    }

    private static @Nullable Battery battery(Document document) {
        Integer percent = whole(document, TelemetryField.BATTERY_PERCENT);
        Double volts = number(document, TelemetryField.BATTERY_VOLTS);
        Double amps = number(document, TelemetryField.BATTERY_AMPS);
        return percent == null && volts == null && amps == null ? null : new Battery(percent, volts, amps);
    }

    private static @Nullable Gps gps(Document document) {
        String fix = document.getString("gps_fix");
        return fix == null
                ? null
                : new Gps(
                        StoredNames.constant(GpsFix.class, fix),
                        whole(document, TelemetryField.SATELLITES),
                        number(document, TelemetryField.HDOP));
    }

    private static @Nullable Double number(Document document, TelemetryField field) {
        return number(document.get(member(field)));
    }

    static @Nullable Double number(@Nullable Object value) {
        return value instanceof Number number ? (Double) number.doubleValue() : null;
    }

    private static @Nullable Integer whole(Document document, TelemetryField field) {
        Double value = number(document, field);
        return value == null ? null : (Integer) value.intValue();
    }
}
