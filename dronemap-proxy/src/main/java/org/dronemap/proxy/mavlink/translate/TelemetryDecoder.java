package org.dronemap.proxy.mavlink.translate;

import java.util.Optional;
import org.dronemap.core.drone.Attitude;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Gps;
import org.dronemap.core.drone.GpsFix;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.drone.Position;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.mavlink.message.GpsRawInt;
import org.dronemap.mavlink.message.HomePosition;
import org.dronemap.mavlink.message.SysStatus;
import org.dronemap.mavlink.message.VfrHud;
import org.dronemap.mavlink.message.Wind;
import org.dronemap.mavlink.message.WindCov;
import org.jspecify.annotations.Nullable;

/**
 * Decodes the fields of MAVLink telemetry into the cloud's values; what is marked unknown is unknown, never 0, nor what
 * was known before. Stateless.
 */
final class TelemetryDecoder {
    private static final double E7 = 1e7;
    private static final int UNKNOWN_U16 = 65_535;
    private static final int UNKNOWN_U8 = 255;
    private static final long PREARM_CHECK = 0x1000_0000L;
    private static final int DEGREES_KNOWN_BELOW = 36_000;
    /** m/s; nobody flies in more. */
    private static final double STRONGEST_WIND = 60;
    /** m/s; what moves faster is no speed. */
    private static final double FASTEST = 10_000;
    /** 1000 km; what is farther from sea level or home is no height. */
    private static final long HIGHEST_MILLIMETERS = 1_000_000_000L;

    private TelemetryDecoder() {}

    static Position position(GlobalPositionInt message) {
        Geodetic point = point(message.lat(), message.lon());
        // Without a place the estimator has no origin, and its altitude is measured from nowhere.
        Double amsl = point == null ? null : meters(message.alt());
        return new Position(point, amsl, meters(message.relativeAlt()));
    }

    /** 0, 0 is where estimators are that do not know; nobody flies there. */
    static @Nullable Geodetic point(int latitudeE7, int longitudeE7) {
        boolean nowhere = latitudeE7 == 0 && longitudeE7 == 0;
        boolean offEarth = Math.abs((long) latitudeE7) > 900_000_000L || Math.abs((long) longitudeE7) > 1_800_000_000L;
        return nowhere || offEarth ? null : new Geodetic(latitudeE7 / E7, longitudeE7 / E7);
    }

    /** Millimetres; null for what is no height. */
    private static @Nullable Double meters(int millimeters) {
        return Math.abs((long) millimeters) >= HIGHEST_MILLIMETERS ? null : Double.valueOf(millimeters / 1000.0);
    }

    static Motion motion(VfrHud message) {
        Double heading = message.heading() >= 0 && message.heading() * 100 <= DEGREES_KNOWN_BELOW
                ? Double.valueOf(message.heading() % 360)
                : null;
        return new Motion(known(message.groundspeed()), known(message.airspeed()), known(message.climb()), heading);
    }

    private static @Nullable Double known(float value) {
        return Math.abs(value) < FASTEST ? Double.valueOf(value) : null;
    }

    /** Null when it does not say how it lies. */
    static @Nullable Attitude attitude(org.dronemap.mavlink.message.Attitude message) {
        boolean known = isAngle(message.roll()) && isAngle(message.pitch()) && isAngle(message.yaw());
        return known
                ? new Attitude(
                        Math.toDegrees(message.roll()),
                        Math.toDegrees(message.pitch()),
                        (Math.toDegrees(message.yaw()) + 360) % 360)
                : null;
    }

    private static boolean isAngle(float radians) {
        return Math.abs(radians) <= 2 * Math.PI;
    }

    static Gps gps(GpsRawInt message) {
        Double hdop = message.eph() == UNKNOWN_U16 ? null : Double.valueOf(message.eph() / 100.0);
        return gps(message.fixType(), message.satellitesVisible(), hdop);
    }

    static Gps gps(int fixType, int satellitesVisible, @Nullable Double hdop) {
        GpsFix fix = switch (fixType) {
            case 2 -> GpsFix.TWO_D;
            case 3, 7, 8 -> GpsFix.THREE_D;
            case 4 -> GpsFix.DGPS;
            case 5 -> GpsFix.RTK_FLOAT;
            case 6 -> GpsFix.RTK_FIXED;
            default -> GpsFix.NONE;
        };
        Integer satellites = satellitesVisible == UNKNOWN_U8 ? null : (Integer) satellitesVisible;
        return new Gps(fix, satellites, hdop);
    }

    /** MAV_LANDED_STATE; null when it does not know. */
    static @Nullable FlightPhase phase(int landedState) {
        return switch (landedState) {
            case 1 -> FlightPhase.ON_GROUND;
            case 2 -> FlightPhase.IN_AIR;
            case 3 -> FlightPhase.TAKING_OFF;
            case 4 -> FlightPhase.LANDING;
            default -> null;
        };
    }

    /** ArduPilot's word: where it comes from. */
    static Optional<DroneEvent> wind(Wind message) {
        return wind(message.direction(), message.speed());
    }

    /** PX4's: where the air moves to, north and east. */
    static Optional<DroneEvent> wind(WindCov message) {
        double from = Math.toDegrees(Math.atan2(-message.windY(), -message.windX()));
        return wind(from, Math.hypot(message.windX(), message.windY()));
    }

    private static Optional<DroneEvent> wind(double fromDegrees, double speed) {
        return Double.isFinite(fromDegrees) && Double.isFinite(speed) && speed >= 0 && speed < STRONGEST_WIND
                ? Optional.of(new DroneEvent.WindReported((fromDegrees % 360 + 360) % 360, speed))
                : Optional.empty();
    }

    /** Null when the vehicle does not report its pre-arm checks. */
    static @Nullable Boolean readyToArm(SysStatus message) {
        return (message.onboardControlSensorsPresent() & PREARM_CHECK) == 0
                ? null
                : (Boolean) ((message.onboardControlSensorsHealth() & PREARM_CHECK) != 0);
    }

    /** Null when the vehicle says that it has none. */
    static @Nullable Home home(HomePosition message) {
        Geodetic point = point(message.latitude(), message.longitude());
        Double altitude = meters(message.altitude());
        return point == null || altitude == null ? null : new Home(point, altitude);
    }
}
