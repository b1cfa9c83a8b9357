package org.dronemap.proxy.mavlink.translate;

import org.dronemap.core.drone.Motion;
import org.dronemap.core.drone.Position;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.HighLatency;
import org.dronemap.mavlink.message.HighLatency2;
import org.jspecify.annotations.Nullable;

/**
 * Reads HIGH_LATENCY and HIGH_LATENCY2, in which a vehicle on a slow or dear link, such as a satellite's, says all at
 * once what it says in many messages elsewhere. Stateless.
 */
public final class HighLatencyReader {
    private static final int ARDUPILOT = 3;
    private static final int PX4 = 12;
    private static final int CUSTOM_MODE_ENABLED = 1;
    private static final int ARMED = 128;
    private static final int MODE_VERSION = 3;
    private static final int UNKNOWN_U8 = 255;
    private static final double STEPS_OF_SPEED = 5;
    private static final int STEPS_OF_HEADING = 2;

    private HighLatencyReader() {}

    /**
     * The heartbeat that such a message stands for.
     *
     * @param last the vehicle's last one, of which comes what this one leaves open; null: there was none
     */
    public static Heartbeat heartbeat(HighLatency2 message, @Nullable Heartbeat last) {
        return new Heartbeat(
                message.type(),
                message.autopilot(),
                reportsArmed(message)
                        ? message.custom0() & 0xFF
                        : CUSTOM_MODE_ENABLED | (last == null ? 0 : last.baseMode() & ARMED),
                message.autopilot() == PX4 ? (long) message.customMode() << 16 : message.customMode(),
                last == null ? 0 : last.systemStatus(),
                MODE_VERSION);
    }

    /** ArduPilot's has the base mode in a field of its own use; others do not say whether they are armed. */
    static boolean reportsArmed(HighLatency2 message) {
        return message.autopilot() == ARDUPILOT;
    }

    /** {@code type} and {@code autopilot} are not in this one. */
    static Heartbeat heartbeat(HighLatency message, int type, @Nullable Heartbeat last) {
        return new Heartbeat(
                type,
                last == null ? ARDUPILOT : last.autopilot(),
                message.baseMode(),
                message.customMode(),
                last == null ? 0 : last.systemStatus(),
                MODE_VERSION);
    }

    /** {@code homeAmslMeters}: above what its height is told; null: it is not known. */
    static Position position(int latitudeE7, int longitudeE7, int altitudeAmsl, @Nullable Double homeAmslMeters) {
        var point = TelemetryDecoder.point(latitudeE7, longitudeE7);
        boolean known = point != null && altitudeAmsl != Short.MAX_VALUE && altitudeAmsl != Short.MIN_VALUE;
        Double amsl = known ? Double.valueOf(altitudeAmsl) : null;
        return new Position(
                point, amsl, amsl == null || homeAmslMeters == null ? null : Double.valueOf(amsl - homeAmslMeters));
    }

    /** Its rate of climb is the greatest since the last message, which says nothing about now. */
    static Motion motion(HighLatency2 message) {
        Double heading = message.heading() * STEPS_OF_HEADING < 360
                ? Double.valueOf(message.heading() * STEPS_OF_HEADING)
                : null;
        return new Motion(speed(message.groundspeed()), speed(message.airspeed()), null, heading);
    }

    private static @Nullable Double speed(int steps) {
        return steps == UNKNOWN_U8 ? null : Double.valueOf(steps / STEPS_OF_SPEED);
    }

    static Motion motion(HighLatency message) {
        Double heading = message.heading() < 36_000 ? Double.valueOf(message.heading() / 100.0) : null;
        return new Motion(wholeSpeed(message.groundspeed()), wholeSpeed(message.airspeed()), null, heading);
    }

    private static @Nullable Double wholeSpeed(int metersPerSecond) {
        return metersPerSecond == UNKNOWN_U8 ? null : Double.valueOf(metersPerSecond);
    }
}
