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
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.mission.RallyPoint;
import org.dronemap.core.parameter.Parameter;
import org.jspecify.annotations.Nullable;

/** A vehicle's report translated from its protocol, such as a position or mode; changes the state of its drone. */
public sealed interface DroneEvent {
    /** Kinds of events; used in switches without a default, so that a missing case does not compile. */
    enum Kind {
        IDENTIFIED(EarlyBuffering.NOT),
        MODE(EarlyBuffering.NEWEST),
        READINESS(EarlyBuffering.NEWEST),
        PHASE(EarlyBuffering.NEWEST),
        POSITION(EarlyBuffering.NEWEST),
        LOCAL_POSITION(EarlyBuffering.NEWEST),
        MOTION(EarlyBuffering.NEWEST),
        ATTITUDE(EarlyBuffering.NEWEST),
        BATTERY(EarlyBuffering.NEWEST),
        GPS(EarlyBuffering.NEWEST),
        HOME(EarlyBuffering.NEWEST),
        RETURN_HEIGHT_SET(EarlyBuffering.NEWEST),
        MISSION_CURRENT(EarlyBuffering.NEWEST),
        MISSION_ITEM_REACHED(EarlyBuffering.NOT),
        MISSION_READ(EarlyBuffering.NOT),
        PHOTO(EarlyBuffering.NEWEST),
        OUTPUTS(EarlyBuffering.NEWEST),
        READING(EarlyBuffering.NEWEST),
        WIND(EarlyBuffering.NEWEST),
        PARAMETERS_READ(EarlyBuffering.NOT),
        PARAMETER(EarlyBuffering.NOT),
        LOGS_READ(EarlyBuffering.NOT),
        FENCE_READ(EarlyBuffering.NOT),
        RALLY_POINTS_READ(EarlyBuffering.NOT),
        SCAN(EarlyBuffering.NEWEST),
        PICTURE(EarlyBuffering.NEWEST),
        MAP(EarlyBuffering.NEWEST),
        TEXT(EarlyBuffering.FIRST);

        private final EarlyBuffering early;

        Kind(EarlyBuffering early) {
            this.early = early;
        }

        public EarlyBuffering early() {
            return early;
        }
    }

    /** Buffering of an event that arrives before the vehicle's drone is identified: newest, first ones or none. */
    enum EarlyBuffering {
        /** The drone is told the newest. */
        NEWEST,
        /** The drone is told the first ones, in their order. */
        FIRST,
        /** The drone is not told: it asks anew, or it is over. */
        NOT
    }

    Kind kind();

    /** Event with a vehicle's identification and capabilities; repeated whenever more becomes known. */
    record Identified(Identification identification, Capabilities capabilities) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.IDENTIFIED;
        }
    }

    /** {@code mode} is null when the vehicle's mode has no name here; {@code armed} when it told its mode alone. */
    record ModeReported(@Nullable String mode, @Nullable Boolean armed) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.MODE;
        }
    }

    /** The verdict of the vehicle's own pre-arm checks; null when it tells none any more. */
    record ReadinessReported(@Nullable Boolean readyToArm) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.READINESS;
        }
    }

    /** {@code phase} is null when the vehicle says that it does not know any more. */
    record PhaseReported(@Nullable FlightPhase phase) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.PHASE;
        }
    }

    record PositionReported(Position position) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.POSITION;
        }
    }

    record LocalPositionReported(LocalPosition position) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.LOCAL_POSITION;
        }
    }

    record MotionReported(Motion motion) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.MOTION;
        }
    }

    /** {@code attitude} is null when the vehicle says that it does not know it. */
    record AttitudeReported(@Nullable Attitude attitude) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.ATTITUDE;
        }
    }

    record BatteryReported(Battery battery) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.BATTERY;
        }
    }

    record GpsReported(Gps gps) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.GPS;
        }
    }

    /** {@code home} is null when the vehicle says that it has none. */
    record HomeReported(@Nullable Home home) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.HOME;
        }
    }

    /** The cloud has set it. */
    record ReturnHeightSet(ReturnHeight height) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.RETURN_HEIGHT_SET;
        }
    }

    /**
     * Index into the mission's items that it heads for, null when it heads for none; {@code phase} is null when the
     * vehicle does not say it.
     */
    record MissionCurrentReported(
            @Nullable Integer index, @Nullable MissionPhase phase) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.MISSION_CURRENT;
        }
    }

    record MissionItemReached(int index) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.MISSION_ITEM_REACHED;
        }
    }

    /**
     * The whole mission was read from the vehicle; {@code asUploaded}: as the end of the cloud's own upload;
     * {@code hash} of all that the vehicle keeps of it, null when it could not be read exactly; {@code landingSequence}:
     * a fixed wing lands by one of its parts when it is sent home.
     */
    record MissionRead(List<MissionItem> items, @Nullable String hash, boolean asUploaded, boolean landingSequence)
            implements DroneEvent {
        public MissionRead {
            items = List.copyOf(items);
        }

        /** Without a landing sequence. */
        public MissionRead(List<MissionItem> items, @Nullable String hash, boolean asUploaded) {
            this(items, hash, asUploaded, false);
        }

        public MissionRead(List<MissionItem> items, boolean asUploaded) {
            this(items, null, asUploaded);
        }

        @Override
        public Kind kind() {
            return Kind.MISSION_READ;
        }
    }

    /** A picture was taken; {@code number} by the vehicle's count, {@code point} null when it did not say where. */
    record PhotoReported(int number, @Nullable Geodetic point) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.PHOTO;
        }
    }

    /** Pulses of its outputs from 1 on, in microseconds; 0: none. */
    record OutputsReported(List<Integer> pulsesMicros) implements DroneEvent {
        public OutputsReported {
            pulsesMicros = List.copyOf(pulsesMicros);
        }

        @Override
        public Kind kind() {
            return Kind.OUTPUTS;
        }
    }

    /** A sensor's number. */
    record ReadingReported(String name, double value) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.READING;
        }
    }

    /** The wind in flight: where it comes from in degrees clockwise from true north, and m/s. */
    record WindReported(double fromDegrees, double metersPerSecond) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.WIND;
        }
    }

    /** The whole list of parameters was read. */
    record ParametersRead(List<Parameter> parameters) implements DroneEvent {
        public ParametersRead {
            parameters = List.copyOf(parameters);
        }

        @Override
        public Kind kind() {
            return Kind.PARAMETERS_READ;
        }
    }

    /** One parameter was heard, whoever changed it. */
    record ParameterReported(Parameter parameter) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.PARAMETER;
        }
    }

    /** The logs on board were listed. */
    record LogsRead(List<VehicleLog> logs) implements DroneEvent {
        public LogsRead {
            logs = List.copyOf(logs);
        }

        @Override
        public Kind kind() {
            return Kind.LOGS_READ;
        }
    }

    /** The fence on board was read. */
    record FenceRead(List<FenceArea> zones) implements DroneEvent {
        public FenceRead {
            zones = List.copyOf(zones);
        }

        @Override
        public Kind kind() {
            return Kind.FENCE_READ;
        }
    }

    /** The rally points on board were read. */
    record RallyPointsRead(List<RallyPoint> points) implements DroneEvent {
        public RallyPointsRead {
            points = List.copyOf(points);
        }

        @Override
        public Kind kind() {
            return Kind.RALLY_POINTS_READ;
        }
    }

    record ScanReported(RangeScan scan) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.SCAN;
        }
    }

    record PictureReported(Picture picture) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.PICTURE;
        }
    }

    record MapReported(AreaMap map) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.MAP;
        }
    }

    record TextReported(Severity severity, String text) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.TEXT;
        }
    }
}
