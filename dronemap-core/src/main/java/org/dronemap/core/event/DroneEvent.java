package org.dronemap.core.event;

import java.util.List;
import org.dronemap.core.drone.AreaMap;
import org.dronemap.core.drone.Attitude;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Gps;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.LocalPosition;
import org.dronemap.core.drone.MissionPhase;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.drone.Picture;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.RangeScan;
import org.dronemap.core.drone.ReturnHeight;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.drone.VehicleLog;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.FenceZone;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.mission.RallyPoint;
import org.dronemap.core.parameter.Parameter;
import org.jspecify.annotations.Nullable;

/** One thing heard from a vehicle. */
public sealed interface DroneEvent {
    /** Who it is and what it can do; again whenever more becomes known. */
    record Identified(Identification identification, Capabilities capabilities) implements DroneEvent {}

    /** {@code mode} is null when the vehicle's mode has no name here. */
    record ModeHeard(@Nullable String mode, boolean armed) implements DroneEvent {}

    /** The verdict of the vehicle's own pre-arm checks. */
    record ReadinessHeard(boolean readyToArm) implements DroneEvent {}

    record PhaseHeard(FlightPhase phase) implements DroneEvent {}

    record PositionHeard(Position position) implements DroneEvent {}

    record LocalPositionHeard(LocalPosition position) implements DroneEvent {}

    record MotionHeard(Motion motion) implements DroneEvent {}

    record AttitudeHeard(Attitude attitude) implements DroneEvent {}

    record BatteryHeard(Battery battery) implements DroneEvent {}

    record GpsHeard(Gps gps) implements DroneEvent {}

    record HomeHeard(Home home) implements DroneEvent {}

    /** The cloud has set it. */
    record ReturnHeightSet(ReturnHeight height) implements DroneEvent {}

    /**
     * Index into the mission's items that it heads for, null when it heads for none; {@code phase} is null when the
     * vehicle does not say it.
     */
    record MissionCurrentHeard(
            @Nullable Integer index, @Nullable MissionPhase phase) implements DroneEvent {}

    record MissionItemReached(int index) implements DroneEvent {}

    /**
     * The whole mission was read from the vehicle; {@code asUploaded}: as the end of the cloud's own upload;
     * {@code hash} of all that the vehicle keeps of it, null when it could not be read exactly.
     */
    record MissionRead(List<MissionItem> items, @Nullable String hash, boolean asUploaded) implements DroneEvent {
        public MissionRead {
            items = List.copyOf(items);
        }

        public MissionRead(List<MissionItem> items, boolean asUploaded) {
            this(items, null, asUploaded);
        }
    }

    /** Of what the vehicle carries. */
    sealed interface PayloadHeard extends DroneEvent {}

    /** A picture was taken; {@code number} by the vehicle's count, {@code point} null when it did not say where. */
    record PhotoHeard(int number, @Nullable Geodetic point) implements PayloadHeard {}

    /** Pulses of its outputs from 1 on, in microseconds; 0: none. */
    record OutputsHeard(List<Integer> pulsesMicros) implements PayloadHeard {
        public OutputsHeard {
            pulsesMicros = List.copyOf(pulsesMicros);
        }
    }

    /** A sensor's number. */
    record ReadingHeard(String name, double value) implements PayloadHeard {}

    /** The wind in flight: where it comes from in degrees clockwise from true north, and m/s. */
    record WindHeard(double fromDegrees, double metersPerSecond) implements PayloadHeard {}

    /** Of what the vehicle keeps on board beside its mission. */
    sealed interface OnBoardHeard extends DroneEvent {}

    /** The whole list of parameters was read. */
    record ParametersRead(List<Parameter> parameters) implements OnBoardHeard {
        public ParametersRead {
            parameters = List.copyOf(parameters);
        }
    }

    /** One parameter was heard, whoever changed it. */
    record ParameterHeard(Parameter parameter) implements OnBoardHeard {}

    /** The logs on board were listed. */
    record LogsRead(List<VehicleLog> logs) implements OnBoardHeard {
        public LogsRead {
            logs = List.copyOf(logs);
        }
    }

    /** The fence on board was read. */
    record FenceRead(List<FenceZone> zones) implements OnBoardHeard {
        public FenceRead {
            zones = List.copyOf(zones);
        }
    }

    /** The rally points on board were read. */
    record RallyPointsRead(List<RallyPoint> points) implements OnBoardHeard {
        public RallyPointsRead {
            points = List.copyOf(points);
        }
    }

    /** Of what the vehicle's sensors bring. */
    sealed interface SensedHeard extends DroneEvent {}

    record ScanHeard(RangeScan scan) implements SensedHeard {}

    record PictureHeard(Picture picture) implements SensedHeard {}

    record MapHeard(AreaMap map) implements SensedHeard {}

    record TextHeard(Severity severity, String text) implements DroneEvent {}
}
