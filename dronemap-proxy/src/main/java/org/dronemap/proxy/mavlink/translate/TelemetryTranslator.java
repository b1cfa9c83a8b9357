package org.dronemap.proxy.mavlink.translate;

import java.util.Optional;
import java.util.function.Consumer;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.MissionPhase;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.AutopilotVersion;
import org.dronemap.mavlink.message.BatteryStatus;
import org.dronemap.mavlink.message.EkfStatusReport;
import org.dronemap.mavlink.message.ExtendedSysState;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.HighLatency;
import org.dronemap.mavlink.message.HighLatency2;
import org.dronemap.mavlink.message.HomePosition;
import org.dronemap.mavlink.message.MissionCurrent;
import org.dronemap.mavlink.message.MissionItemReached;
import org.dronemap.mavlink.message.ServoOutputRaw;
import org.dronemap.mavlink.message.Statustext;
import org.dronemap.mavlink.message.SysStatus;
import org.dronemap.mavlink.message.VfrHud;
import org.dronemap.mavlink.message.Wind;
import org.dronemap.mavlink.message.WindCov;
import org.jspecify.annotations.Nullable;

/**
 * Translates the telemetry of a MAVLink vehicle into drone events, and updates the status that commands depend on.
 * Owned by the drone's lane.
 */
public final class TelemetryTranslator {
    private static final int UNKNOWN_U16 = 65_535;

    private final VehicleStatus status;
    private final Consumer<DroneEvent> out;
    private final BatteryReader batteries = new BatteryReader();
    private final HighLatencyTranslator summaries;
    private final ReadinessReports readiness = new ReadinessReports();
    private AutopilotAdapter autopilot;
    private final StatustextJoiner texts;
    private boolean phasePublished;

    public TelemetryTranslator(AutopilotAdapter autopilot, VehicleStatus status, Consumer<DroneEvent> out) {
        this.autopilot = autopilot;
        this.status = status;
        this.out = out;
        this.summaries = new HighLatencyTranslator(autopilot, status, batteries, out);
        this.texts = new StatustextJoiner((severity, text) -> out.accept(new DroneEvent.TextReported(severity, text)));
    }

    /** A frame of the vehicle's autopilot. */
    public void received(Frame frame, long nowNanos) {
        switch (frame.messageId()) {
            case Heartbeat.ID -> heartbeat(Heartbeat.decode(frame));
            case SysStatus.ID -> sysStatus(SysStatus.decode(frame), nowNanos);
            case BatteryStatus.ID -> battery(batteries.received(BatteryStatus.decode(frame), nowNanos));
            case GlobalPositionInt.ID -> position(GlobalPositionInt.decode(frame));
            case org.dronemap.mavlink.message.GpsRawInt.ID ->
                out.accept(new DroneEvent.GpsReported(
                        TelemetryDecoder.gps(org.dronemap.mavlink.message.GpsRawInt.decode(frame))));
            case org.dronemap.mavlink.message.Attitude.ID ->
                out.accept(new DroneEvent.AttitudeReported(
                        TelemetryDecoder.attitude(org.dronemap.mavlink.message.Attitude.decode(frame))));
            case VfrHud.ID -> out.accept(new DroneEvent.MotionReported(TelemetryDecoder.motion(VfrHud.decode(frame))));
            case Statustext.ID -> texts.received(frame, nowNanos);
            case HighLatency.ID, HighLatency2.ID -> summaries.received(frame, nowNanos);
            default -> rare(frame);
        }
    }

    private void rare(Frame frame) {
        switch (frame.messageId()) {
            case ExtendedSysState.ID -> landedState(ExtendedSysState.decode(frame));
            case EkfStatusReport.ID -> estimated(EkfStatusReport.decode(frame));
            case HomePosition.ID -> home(HomePosition.decode(frame));
            case MissionCurrent.ID -> missionCurrent(MissionCurrent.decode(frame));
            case MissionItemReached.ID -> reached(MissionItemReached.decode(frame));
            case AutopilotVersion.ID -> {
                status.version(AutopilotVersion.decode(frame));
                identified();
            }
            case Wind.ID -> wind(TelemetryDecoder.wind(Wind.decode(frame)));
            case WindCov.ID -> wind(TelemetryDecoder.wind(WindCov.decode(frame)));
            case ServoOutputRaw.ID ->
                PayloadTranslator.outputs(ServoOutputRaw.decode(frame)).ifPresent(out);
            default -> PayloadTranslator.translate(frame).ifPresent(out);
        }
    }

    /** On the ground its estimate says nothing. */
    private void wind(Optional<DroneEvent> heard) {
        if (status.airborne()) {
            heard.ifPresent(out);
        }
    }

    /** Another component of the same vehicle, such as a camera or a computer beside the autopilot. */
    public void receivedFromComponent(Frame frame, long nowNanos) {
        if (frame.messageId() == Statustext.ID) {
            texts.received(frame, nowNanos);
        } else {
            PayloadTranslator.translate(frame).ifPresent(out);
        }
    }

    public void advance(long nowNanos) {
        texts.advance(nowNanos);
    }

    /** The vehicle has turned out to be of another type: says who it is. */
    public void becomes(AutopilotAdapter other) {
        autopilot = other;
        identified();
    }

    /** Says who the vehicle is and what it can do. */
    public void identified() {
        out.accept(new DroneEvent.Identified(
                IdentificationReader.of(autopilot, status.type(), status.version()), autopilot.capabilities()));
    }

    /** A program that has the autopilot's numbers, such as a ground station, is none for that. */
    private void heartbeat(Heartbeat heartbeat) {
        if (!VehicleType.isVehicle(heartbeat)) {
            return;
        }
        String mode = autopilot.modeName(heartbeat);
        status.heartbeat(heartbeat, mode);
        out.accept(new DroneEvent.ModeReported(mode, status.armed()));
        if (!phasePublished) {
            phase(autopilot.phase(heartbeat));
        }
    }

    private void landedState(ExtendedSysState state) {
        FlightPhase phase = TelemetryDecoder.phase(state.landedState());
        if (phase == null && phasePublished) {
            status.phase(null);
            out.accept(new DroneEvent.PhaseReported(null));
        }
        phasePublished = phase != null;
        phase(phase);
    }

    /** What cannot fly may say that it does: PX4's rovers do as long as they are armed. */
    private void phase(@Nullable FlightPhase phase) {
        boolean flies = !VehicleType.kind(status.type()).neverFlies();
        if (flies && phase != null) {
            status.phase(phase);
            out.accept(new DroneEvent.PhaseReported(phase));
        }
    }

    private void sysStatus(SysStatus message, long nowNanos) {
        battery(batteries.received(message, nowNanos));
        ready(readiness.received(message));
    }

    private void estimated(EkfStatusReport message) {
        status.placeKnown(ReadinessReports.isPlaceKnown(message));
        ready(readiness.received(message));
    }

    private void ready(@Nullable Boolean known) {
        out.accept(new DroneEvent.ReadinessReported(known));
    }

    private void battery(Optional<Battery> known) {
        known.ifPresent(battery -> out.accept(new DroneEvent.BatteryReported(battery)));
    }

    private void position(GlobalPositionInt message) {
        Position position = TelemetryDecoder.position(message);
        status.position(position);
        out.accept(new DroneEvent.PositionReported(position));
    }

    private void home(HomePosition message) {
        Home home = TelemetryDecoder.home(message);
        if (home == null) {
            status.homeUnknown();
        } else {
            status.home(message.latitude(), message.longitude(), home.altitudeAmslMeters());
        }
        out.accept(new DroneEvent.HomeReported(home));
    }

    private void missionCurrent(MissionCurrent message) {
        boolean known = message.seq() != UNKNOWN_U16;
        if (known) {
            status.current(message.seq(), message.missionState());
        }
        int index = message.seq() - autopilot.itemsBeforeMission();
        Integer heading = !known || index < 0 || status.hasNoMission() ? null : (Integer) index;
        out.accept(new DroneEvent.MissionCurrentReported(heading, phase(message.missionState())));
    }

    /** MISSION_STATE; ArduPilot says NOT_STARTED also of a mission that it left in the middle. */
    private static @Nullable MissionPhase phase(int missionState) {
        return switch (missionState) {
            case 2 -> MissionPhase.STOPPED;
            case 3 -> MissionPhase.RUNNING;
            case 4 -> MissionPhase.PAUSED;
            case 5 -> MissionPhase.COMPLETE;
            default -> null;
        };
    }

    private void reached(MissionItemReached message) {
        if (message.seq() == UNKNOWN_U16) {
            return;
        }
        status.reached(message.seq());
        int index = message.seq() - autopilot.itemsBeforeMission();
        if (index >= 0) {
            out.accept(new DroneEvent.MissionItemReached(index));
        }
    }

    /** Something the cloud has to say about this drone, among the drone's own sentences. */
    public void remark(String sentence) {
        out.accept(new DroneEvent.TextReported(Severity.WARNING, sentence));
    }
}
