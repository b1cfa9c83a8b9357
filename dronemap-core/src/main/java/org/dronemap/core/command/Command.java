package org.dronemap.core.command;

import java.util.List;
import java.util.Locale;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.VehicleLog;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.CountText;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.parameter.ParameterValue;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * A discrete command to a drone, such as to arm, take off or upload a mission. Discrete: each one ends in exactly one
 * {@link Outcome}.
 */
public sealed interface Command {
    CommandKind kind();

    /** A phrase for people: "take off to 20 m". */
    String summary();

    @Stored(as = "Arm")
    record Arm() implements Command {
        @Override
        public CommandKind kind() {
            return CommandKind.ARM;
        }

        @Override
        public String summary() {
            return "arm";
        }
    }

    /** {@code force} stops the motors even in the air. */
    @Stored(as = "Disarm", names = "force")
    record Disarm(boolean force) implements Command {
        @Override
        public CommandKind kind() {
            return CommandKind.DISARM;
        }

        @Override
        public String summary() {
            return force ? "stop the motors at once" : "disarm";
        }
    }

    @Stored(as = "SetMode", names = "mode")
    record SetMode(String mode) implements Command {
        @Override
        public CommandKind kind() {
            return CommandKind.SET_MODE;
        }

        @Override
        public String summary() {
            return "change mode to " + mode;
        }
    }

    /** Climb to a height of 1 to 500 m above home. */
    @Stored(as = "TakeOff", names = "altitudeMeters")
    record TakeOff(double altitudeMeters) implements Command {
        public TakeOff {
            if (!(altitudeMeters >= 1 && altitudeMeters <= 500)) {
                throw new IllegalArgumentException("take-off altitude must be 1 to 500 m: " + altitudeMeters);
            }
        }

        @Override
        public CommandKind kind() {
            return CommandKind.TAKE_OFF;
        }

        @Override
        public String summary() {
            return String.format(Locale.ROOT, "take off to %.0f m", altitudeMeters);
        }
    }

    @Stored(as = "Land")
    record Land() implements Command {
        @Override
        public CommandKind kind() {
            return CommandKind.LAND;
        }

        @Override
        public String summary() {
            return "land";
        }
    }

    @Stored(as = "ReturnToLaunch")
    record ReturnToLaunch() implements Command {
        @Override
        public CommandKind kind() {
            return CommandKind.RETURN_TO_LAUNCH;
        }

        @Override
        public String summary() {
            return "return to launch";
        }
    }

    @Stored(as = "Hold")
    record Hold() implements Command {
        @Override
        public CommandKind kind() {
            return CommandKind.HOLD;
        }

        @Override
        public String summary() {
            return "hold";
        }
    }

    @Stored(as = "GoTo", names = "point altitude")
    record GoTo(Geodetic point, Altitude altitude) implements Command {
        @Override
        public CommandKind kind() {
            return CommandKind.GO_TO;
        }

        @Override
        public String summary() {
            return String.format(Locale.ROOT, "go to %s at %.0f m", point.words(), altitude.meters());
        }
    }

    @Stored(as = "UploadMission", names = "mission")
    record UploadMission(Mission mission) implements Command {
        @Override
        public CommandKind kind() {
            return CommandKind.UPLOAD_MISSION;
        }

        @Override
        public String summary() {
            return "upload a mission of " + CountText.of(mission.items().size(), "item");
        }
    }

    /**
     * Fly the mission on board, from where it was left.
     *
     * @param onCloudLoss what the vehicle shall do by itself when the cloud falls silent on the way; null: as it was told
     *     before, for a mission that goes on
     * @param anew from its beginning, also in the air
     */
    @Stored(as = "StartMission", names = "onCloudLoss anew")
    record StartMission(@Nullable MissionCloudLossPolicy onCloudLoss, boolean anew) implements Command {
        public StartMission(@Nullable MissionCloudLossPolicy onCloudLoss) {
            this(onCloudLoss, false);
        }

        @Override
        public CommandKind kind() {
            return CommandKind.START_MISSION;
        }

        @Override
        public String summary() {
            return "start the mission";
        }
    }

    @Stored(as = "PauseMission")
    record PauseMission() implements Command {
        @Override
        public CommandKind kind() {
            return CommandKind.PAUSE_MISSION;
        }

        @Override
        public String summary() {
            return "pause the mission";
        }
    }

    @Stored(as = "ClearMission")
    record ClearMission() implements Command {
        @Override
        public CommandKind kind() {
            return CommandKind.CLEAR_MISSION;
        }

        @Override
        public String summary() {
            return "clear the mission";
        }
    }

    /** Turn on the spot from where it looks now, clockwise when positive: -360 to 360 degrees, not 0. */
    @Stored(as = "Turn", names = "degrees")
    record Turn(double degrees) implements Command {
        public Turn {
            if (!(Math.abs(degrees) <= 360 && degrees != 0)) {
                throw new IllegalArgumentException("a turn must be -360 to 360 degrees and not 0: " + degrees);
            }
        }

        @Override
        public CommandKind kind() {
            return CommandKind.TURN;
        }

        @Override
        public String summary() {
            return String.format(Locale.ROOT, "turn by %.0f degrees", degrees);
        }
    }

    /** Make a place the one that it returns to; null for both: where it is now. */
    @Stored(as = "SetHome", names = "point altitude")
    record SetHome(@Nullable Geodetic point, @Nullable Altitude altitude) implements Command {
        public SetHome {
            if ((point == null) != (altitude == null)) {
                throw new IllegalArgumentException("a home has a place and an altitude, or is where the vehicle is");
            }
        }

        @Override
        public CommandKind kind() {
            return CommandKind.SET_HOME;
        }

        @Override
        public String summary() {
            return point == null ? "make this place its home" : "set home to " + point.words();
        }
    }

    @Stored(as = "TakePicture")
    record TakePicture() implements Command {
        @Override
        public CommandKind kind() {
            return CommandKind.TAKE_PICTURE;
        }

        @Override
        public String summary() {
            return "take a picture";
        }
    }

    /** Switch one of the relays 0 to 15. */
    @Stored(as = "SetRelay", names = "relay setting")
    record SetRelay(int relay, RelaySetting setting) implements Command {
        public SetRelay {
            if (relay < 0 || relay > 15) {
                throw new IllegalArgumentException("relays count from 0 to 15: " + relay);
            }
        }

        @Override
        public CommandKind kind() {
            return CommandKind.SET_RELAY;
        }

        @Override
        public String summary() {
            return setting == RelaySetting.TOGGLE
                    ? "toggle relay " + relay
                    : "switch relay " + relay + " " + setting.name().toLowerCase(Locale.ROOT);
        }
    }

    /** Read the whole list of parameters anew. */
    @Stored(as = "ReadParameters")
    record ReadParameters() implements Command {
        @Override
        public CommandKind kind() {
            return CommandKind.READ_PARAMETERS;
        }

        @Override
        public String summary() {
            return "read all parameters";
        }
    }

    /** Change parameters and read each back; 1 to 10,000 of them. */
    @Stored(as = "SetParameters", names = "values")
    record SetParameters(List<ParameterValue> values) implements Command {
        public SetParameters {
            values = List.copyOf(values);
            if (values.isEmpty() || values.size() > 10_000) {
                throw new IllegalArgumentException("1 to 10,000 parameters can be set at once, not " + values.size());
            }
        }

        @Override
        public CommandKind kind() {
            return CommandKind.SET_PARAMETERS;
        }

        @Override
        public String summary() {
            return values.size() == 1 ? "set " + values.get(0).text() : "set " + values.size() + " parameters";
        }
    }

    /** Fetch one log, going on where an earlier attempt ended. */
    @Stored(as = "DownloadLog", names = "log sink")
    record DownloadLog(VehicleLog log, VehicleLogSink sink) implements Command {
        @Override
        public CommandKind kind() {
            return CommandKind.DOWNLOAD_LOG;
        }

        @Override
        public String summary() {
            return "download log " + log.number();
        }
    }

    /** Commands that are declared in files of their own. */
    sealed interface Standalone extends Command
            permits GoToLocal,
                    ChangeSpeed,
                    EmergencyStop,
                    ReadMap,
                    ReadHome,
                    ReadLogs,
                    ReadFence,
                    ReadRallyPoints,
                    SetReturnOnCloudLoss,
                    SetReturnHeight,
                    SetCloudLossAction,
                    RestoreParameters,
                    SetFence,
                    SetRallyPoints {}

    /** What the vehicle must be able to do for it. */
    default Capability needs() {
        return kind().needs();
    }
}
