package org.dronemap.proxy.mavlink.translate;

import java.util.Optional;
import org.dronemap.core.drone.Attitude;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.Gps;
import org.dronemap.core.drone.GpsFix;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.drone.Position;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.mavlink.message.BatteryStatus;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.mavlink.message.GpsRawInt;
import org.dronemap.mavlink.message.HomePosition;
import org.dronemap.mavlink.message.SysStatus;
import org.dronemap.mavlink.message.VfrHud;
import org.dronemap.mavlink.message.Wind;
import org.dronemap.mavlink.message.WindCov;
import org.jspecify.annotations.Nullable;

/**
 * Decodes the fields of MAVLink telemetry into the cloud's values; what is marked unknown stays unknown, never 0. Owned
 * by the drone's lane.
 */
final class TelemetryDecoder {
    private static final double E7 = 1e7;
    private static final int UNKNOWN_U16 = 65_535;
    private static final int UNKNOWN_U8 = 255;
    private static final int DEGREES_KNOWN_BELOW = 36_000;
    /** m/s; nobody flies in more. */
    private static final double STRONGEST_WIND = 60;

    private @Nullable Integer percent;
    private @Nullable Double volts;
    private @Nullable Double amps;
    private boolean systemStatusHasCharge;

    /** Charge, volts and amperes of the main battery. */
    Optional<Battery> battery(SysStatus message) {
        systemStatusHasCharge = isPercent(message.batteryRemaining());
        if (systemStatusHasCharge) {
            percent = message.batteryRemaining();
        }
        int millivolts = message.voltageBattery();
        volts = millivolts == UNKNOWN_U16 || millivolts == 0 ? null : Double.valueOf(millivolts / 1000.0);
        amps = message.currentBattery() == -1 ? null : Double.valueOf(message.currentBattery() / 100.0);
        return battery();
    }

    /** What SYS_STATUS left open. */
    Optional<Battery> battery(BatteryStatus message) {
        if (message.id() != 0) {
            return Optional.empty();
        }
        if (!systemStatusHasCharge) {
            percent = isPercent(message.batteryRemaining()) ? (Integer) message.batteryRemaining() : null;
        }
        if (volts == null) {
            int millivolts = 0;
            for (int cell : message.voltages()) {
                millivolts += cell == UNKNOWN_U16 ? 0 : cell;
            }
            volts = millivolts == 0 ? null : Double.valueOf(millivolts / 1000.0);
        }
        if (amps == null && message.currentBattery() != -1) {
            amps = message.currentBattery() / 100.0;
        }
        return battery();
    }

    private static boolean isPercent(int value) {
        return value >= 0 && value <= 100;
    }

    private Optional<Battery> battery() {
        return percent == null && volts == null && amps == null
                ? Optional.empty()
                : Optional.of(new Battery(percent, volts, amps));
    }

    Optional<Position> position(GlobalPositionInt message) {
        Geodetic point = point(message.lat(), message.lon());
        Double aboveHome =
                message.relativeAlt() == Integer.MAX_VALUE ? null : Double.valueOf(message.relativeAlt() / 1000.0);
        // Without a place the estimator has no origin, and its altitude is measured from nowhere.
        Double amsl =
                point == null || message.alt() == Integer.MAX_VALUE ? null : Double.valueOf(message.alt() / 1000.0);
        return Optional.of(new Position(point, amsl, aboveHome));
    }

    /** 0, 0 is where estimators are that do not know; nobody flies there. */
    static @Nullable Geodetic point(int latitudeE7, int longitudeE7) {
        boolean nowhere = latitudeE7 == 0 && longitudeE7 == 0;
        boolean offEarth = Math.abs((long) latitudeE7) > 900_000_000L || Math.abs((long) longitudeE7) > 1_800_000_000L;
        return nowhere || offEarth ? null : new Geodetic(latitudeE7 / E7, longitudeE7 / E7);
    }

    Optional<Motion> motion(VfrHud message) {
        Double heading = message.heading() >= 0 && message.heading() * 100 <= DEGREES_KNOWN_BELOW
                ? Double.valueOf(message.heading() % 360)
                : null;
        return Optional.of(
                new Motion(known(message.groundspeed()), known(message.airspeed()), known(message.climb()), heading));
    }

    private static @Nullable Double known(float value) {
        return Float.isFinite(value) ? Double.valueOf(value) : null;
    }

    Optional<Attitude> attitude(org.dronemap.mavlink.message.Attitude message) {
        boolean known =
                Float.isFinite(message.roll()) && Float.isFinite(message.pitch()) && Float.isFinite(message.yaw());
        return known
                ? Optional.of(new Attitude(
                        Math.toDegrees(message.roll()),
                        Math.toDegrees(message.pitch()),
                        (Math.toDegrees(message.yaw()) + 360) % 360))
                : Optional.empty();
    }

    Optional<Gps> gps(GpsRawInt message) {
        GpsFix fix = switch (message.fixType()) {
            case 2 -> GpsFix.TWO_D;
            case 3, 7, 8 -> GpsFix.THREE_D;
            case 4 -> GpsFix.DGPS;
            case 5 -> GpsFix.RTK_FLOAT;
            case 6 -> GpsFix.RTK_FIXED;
            default -> GpsFix.NONE;
        };
        Integer satellites = message.satellitesVisible() == UNKNOWN_U8 ? null : (Integer) message.satellitesVisible();
        Double hdop = message.eph() == UNKNOWN_U16 ? null : Double.valueOf(message.eph() / 100.0);
        return Optional.of(new Gps(fix, satellites, hdop));
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

    static Optional<Home> home(HomePosition message) {
        Geodetic point = point(message.latitude(), message.longitude());
        return point == null || message.altitude() == Integer.MAX_VALUE
                ? Optional.empty()
                : Optional.of(new Home(point, message.altitude() / 1000.0));
    }
}
