package org.dronemap.core.history;

import org.dronemap.core.drone.Attitude;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.Gps;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/** A numeric field of a TelemetryPoint that can be drawn over time, with its unit. */
@Stored(
        names = "latitude longitude altitude_amsl altitude_above_home ground_speed air_speed "
                + "climb_rate heading roll pitch yaw battery_percent battery_volts battery_amps "
                + "satellites hdop loss_short loss_long round_trip mission_item jitter jitter_long")
public enum TelemetryField {
    LATITUDE("°"),
    LONGITUDE("°"),
    ALTITUDE_AMSL("m"),
    ALTITUDE_ABOVE_HOME("m"),
    GROUND_SPEED("m/s"),
    AIR_SPEED("m/s"),
    CLIMB_RATE("m/s"),
    HEADING("°"),
    ROLL("°"),
    PITCH("°"),
    YAW("°"),
    BATTERY_PERCENT("%"),
    BATTERY_VOLTS("V"),
    BATTERY_AMPS("A"),
    SATELLITES(""),
    HDOP(""),
    LOSS_SHORT(""),
    LOSS_LONG(""),
    ROUND_TRIP("ms"),
    MISSION_ITEM(""),
    JITTER("ms"),
    JITTER_LONG("ms");

    private final String unit;

    TelemetryField(String unit) {
        this.unit = unit;
    }

    /** As people write it; empty for a count or a share. */
    public String unit() {
        return unit;
    }

    /** Null when it was not known. */
    public @Nullable Double of(TelemetryPoint point) {
        return switch (this) {
            case LATITUDE, LONGITUDE, ALTITUDE_AMSL, ALTITUDE_ABOVE_HOME -> of(point.position());
            case GROUND_SPEED, AIR_SPEED, CLIMB_RATE, HEADING -> of(point.motion());
            case ROLL, PITCH, YAW -> of(point.attitude());
            case BATTERY_PERCENT, BATTERY_VOLTS, BATTERY_AMPS -> of(point.battery());
            case SATELLITES, HDOP -> of(point.gps());
            case LOSS_SHORT, LOSS_LONG, ROUND_TRIP, JITTER, JITTER_LONG -> of(point.quality());
            case MISSION_ITEM -> number(point.missionItem());
        };
    }

    private @Nullable Double of(@Nullable Position position) {
        if (position == null) {
            return null;
        }
        if (this == ALTITUDE_AMSL) {
            return position.altitudeAmslMeters();
        }
        if (this == ALTITUDE_ABOVE_HOME) {
            return position.altitudeAboveHomeMeters();
        }
        Geodetic point = position.point();
        if (point == null) {
            return null;
        }
        return this == LATITUDE ? point.latitudeDegrees() : point.longitudeDegrees();
    }

    private @Nullable Double of(@Nullable Motion motion) {
        if (motion == null) {
            return null;
        }
        return switch (this) {
            case GROUND_SPEED -> motion.groundSpeed();
            case AIR_SPEED -> motion.airSpeed();
            case CLIMB_RATE -> motion.climbRate();
            default -> motion.headingDegrees();
        };
    }

    private @Nullable Double of(@Nullable Attitude attitude) {
        if (attitude == null) {
            return null;
        }
        return switch (this) {
            case ROLL -> attitude.rollDegrees();
            case PITCH -> attitude.pitchDegrees();
            default -> attitude.yawDegrees();
        };
    }

    private @Nullable Double of(@Nullable Battery battery) {
        if (battery == null) {
            return null;
        }
        return switch (this) {
            case BATTERY_PERCENT -> number(battery.percent());
            case BATTERY_VOLTS -> battery.volts();
            default -> battery.amps();
        };
    }

    private @Nullable Double of(@Nullable Gps gps) {
        if (gps == null) {
            return null;
        }
        return this == HDOP ? gps.hdop() : number(gps.satellites());
    }

    private @Nullable Double of(LinkQuality quality) {
        return switch (this) {
            case LOSS_SHORT -> quality.lossShort();
            case LOSS_LONG -> quality.lossLong();
            case JITTER -> quality.jitterMillis();
            case JITTER_LONG -> quality.jitterLongMillis();
            default -> quality.roundTripMillis();
        };
    }

    private static @Nullable Double number(@Nullable Integer whole) {
        return whole == null ? null : (Double) whole.doubleValue();
    }
}
