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
    /** What there is of events; switched over without a default, so that a forgotten one does not compile. */
    enum Kind {
        IDENTIFIED(Early.NOT),
        MODE(Early.NEWEST),
        READINESS(Early.NEWEST),
        PHASE(Early.NEWEST),
        POSITION(Early.NEWEST),
        LOCAL_POSITION(Early.NEWEST),
        MOTION(Early.NEWEST),
        ATTITUDE(Early.NEWEST),
        BATTERY(Early.NEWEST),
        GPS(Early.NEWEST),
        HOME(Early.NEWEST),
        RETURN_HEIGHT_SET(Early.NEWEST),
        MISSION_CURRENT(Early.NEWEST),
        MISSION_ITEM_REACHED(Early.NOT),
        MISSION_READ(Early.NOT),
        PHOTO(Early.NEWEST),
        OUTPUTS(Early.NEWEST),
        READING(Early.NEWEST),
        WIND(Early.NEWEST),
        PARAMETERS_READ(Early.NOT),
        PARAMETER(Early.NOT),
        LOGS_READ(Early.NOT),
        FENCE_READ(Early.NOT),
        RALLY_POINTS_READ(Early.NOT),
        SCAN(Early.NEWEST),
        PICTURE(Early.NEWEST),
        MAP(Early.NEWEST),
        TEXT(Early.FIRST);

        private final Early early;

        Kind(Early early) {
            this.early = early;
        }

        public Early early() {
            return early;
        }
    }

    /** What becomes of an event that is heard before it is known which drone the vehicle is. */
    enum Early {
        /** The drone is told the newest. */
        NEWEST,
        /** The drone is told the first ones, in their order. */
        FIRST,
        /** The drone is not told: it asks anew, or it is over. */
        NOT
    }

    Kind kind();

    /** Who it is and what it can do; again whenever more becomes known. */
    record Identified(Identification identification, Capabilities capabilities) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.IDENTIFIED;
        }
    }

    /** {@code mode} is null when the vehicle's mode has no name here. */
    record ModeHeard(@Nullable String mode, boolean armed) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.MODE;
        }
    }

    /** The verdict of the vehicle's own pre-arm checks. */
    record ReadinessHeard(boolean readyToArm) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.READINESS;
        }
    }

    record PhaseHeard(FlightPhase phase) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.PHASE;
        }
    }

    record PositionHeard(Position position) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.POSITION;
        }
    }

    record LocalPositionHeard(LocalPosition position) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.LOCAL_POSITION;
        }
    }

    record MotionHeard(Motion motion) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.MOTION;
        }
    }

    record AttitudeHeard(Attitude attitude) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.ATTITUDE;
        }
    }

    record BatteryHeard(Battery battery) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.BATTERY;
        }
    }

    record GpsHeard(Gps gps) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.GPS;
        }
    }

    record HomeHeard(Home home) implements DroneEvent {
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
    record MissionCurrentHeard(
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
    record PhotoHeard(int number, @Nullable Geodetic point) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.PHOTO;
        }
    }

    /** Pulses of its outputs from 1 on, in microseconds; 0: none. */
    record OutputsHeard(List<Integer> pulsesMicros) implements DroneEvent {
        public OutputsHeard {
            pulsesMicros = List.copyOf(pulsesMicros);
        }

        @Override
        public Kind kind() {
            return Kind.OUTPUTS;
        }
    }

    /** A sensor's number. */
    record ReadingHeard(String name, double value) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.READING;
        }
    }

    /** The wind in flight: where it comes from in degrees clockwise from true north, and m/s. */
    record WindHeard(double fromDegrees, double metersPerSecond) implements DroneEvent {
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
    record ParameterHeard(Parameter parameter) implements DroneEvent {
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
    record FenceRead(List<FenceZone> zones) implements DroneEvent {
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

    record ScanHeard(RangeScan scan) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.SCAN;
        }
    }

    record PictureHeard(Picture picture) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.PICTURE;
        }
    }

    record MapHeard(AreaMap map) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.MAP;
        }
    }

    record TextHeard(Severity severity, String text) implements DroneEvent {
        @Override
        public Kind kind() {
            return Kind.TEXT;
        }
    }
}
