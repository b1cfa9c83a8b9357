package org.dronemap.proxy.mavlink.translate;

import java.util.function.Consumer;
import org.dronemap.core.drone.Attitude;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Position;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.HighLatency;
import org.dronemap.mavlink.message.HighLatency2;
import org.jspecify.annotations.Nullable;

/** Translates HIGH_LATENCY and HIGH_LATENCY2 of a MAVLink vehicle into drone events. Owned by the drone's lane. */
final class HighLatencyTranslator {
    private static final int UNKNOWN_U8 = 255;
    private static final int UNKNOWN_U16 = 65_535;
    private static final double CENTIDEGREES = 100;

    private static final int MISSION_STATE_UNKNOWN = 0;
    private final AutopilotAdapter autopilot;
    private final VehicleStatus status;
    private final BatteryReader batteries;
    private final Consumer<DroneEvent> out;

    HighLatencyTranslator(
            AutopilotAdapter autopilot, VehicleStatus status, BatteryReader batteries, Consumer<DroneEvent> out) {
        this.autopilot = autopilot;
        this.status = status;
        this.batteries = batteries;
        this.out = out;
    }

    void received(Frame frame, long nowNanos) {
        if (frame.messageId() == HighLatency2.ID) {
            received(HighLatency2.decode(frame), nowNanos);
        } else {
            received(HighLatency.decode(frame), nowNanos);
        }
    }

    private void received(HighLatency2 message, long nowNanos) {
        Heartbeat heartbeat = HighLatencyReader.heartbeat(message, status.heartbeat());
        boolean reportsArmed = HighLatencyReader.reportsArmed(message);
        mode(heartbeat, reportsArmed);
        if (reportsArmed) {
            phase(status.armed() ? null : FlightPhase.ON_GROUND);
        }
        position(message.latitude(), message.longitude(), message.altitude());
        out.accept(new DroneEvent.MotionReported(HighLatencyReader.motion(message)));
        battery(message.battery(), nowNanos);
        waypoint(message.wpNum(), UNKNOWN_U16);
    }

    private void received(HighLatency message, long nowNanos) {
        mode(HighLatencyReader.heartbeat(message, status.type(), status.heartbeat()), true);
        FlightPhase told = TelemetryDecoder.phase(message.landedState());
        phase(told == null && !status.armed() ? FlightPhase.ON_GROUND : told);
        position(message.latitude(), message.longitude(), message.altitudeAmsl());
        out.accept(new DroneEvent.MotionReported(HighLatencyReader.motion(message)));
        out.accept(new DroneEvent.AttitudeReported(attitude(message)));
        out.accept(new DroneEvent.GpsReported(TelemetryDecoder.gps(message.gpsFixType(), message.gpsNsat(), null)));
        battery(message.batteryRemaining(), nowNanos);
        waypoint(message.wpNum(), UNKNOWN_U8);
    }

    private void mode(Heartbeat heartbeat, boolean reportsArmed) {
        String mode = autopilot.modeName(heartbeat);
        status.heartbeat(heartbeat, mode);
        out.accept(new DroneEvent.ModeReported(mode, reportsArmed ? (Boolean) status.armed() : null));
    }

    /** Null: what was said before may be over; its height tells then. */
    private void phase(@Nullable FlightPhase phase) {
        status.phase(phase);
        out.accept(new DroneEvent.PhaseReported(phase));
    }

    private void position(int latitudeE7, int longitudeE7, int altitudeAmsl) {
        Position position =
                HighLatencyReader.position(latitudeE7, longitudeE7, altitudeAmsl, status.homeAltitudeAmslMeters());
        status.position(position);
        out.accept(new DroneEvent.PositionReported(position));
    }

    private static @Nullable Attitude attitude(HighLatency message) {
        boolean known = message.roll() != Short.MAX_VALUE
                && message.pitch() != Short.MAX_VALUE
                && message.heading() < 360 * CENTIDEGREES;
        return known
                ? new Attitude(
                        message.roll() / CENTIDEGREES, message.pitch() / CENTIDEGREES, message.heading() / CENTIDEGREES)
                : null;
    }

    private void battery(int remaining, long nowNanos) {
        batteries
                .received(remaining, nowNanos)
                .ifPresent(battery -> out.accept(new DroneEvent.BatteryReported(battery)));
    }

    private void waypoint(int seq, int unknown) {
        int index = seq - autopilot.itemsBeforeMission();
        if (seq != unknown) {
            status.current(seq, MISSION_STATE_UNKNOWN);
        }
        Integer heading = seq == unknown || index < 0 || status.hasNoMission() ? null : (Integer) index;
        out.accept(new DroneEvent.MissionCurrentReported(heading, null));
    }
}
