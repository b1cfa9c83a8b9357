package org.dronemap.proxy.fuzz;

import java.util.BitSet;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Stream;
import org.dronemap.core.command.CloudLoss;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandKind;
import org.dronemap.core.command.EmergencyStop;
import org.dronemap.core.command.GoToLocal;
import org.dronemap.core.command.LogSink;
import org.dronemap.core.command.OwnersKeeper;
import org.dronemap.core.command.PutBack;
import org.dronemap.core.command.ReadFence;
import org.dronemap.core.command.ReadHome;
import org.dronemap.core.command.ReadLogs;
import org.dronemap.core.command.ReadMap;
import org.dronemap.core.command.ReadRallyPoints;
import org.dronemap.core.command.RelaySetting;
import org.dronemap.core.command.ReturnOnLoss;
import org.dronemap.core.command.SetCloudLoss;
import org.dronemap.core.command.SetReturnHeight;
import org.dronemap.core.drone.VehicleLog;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceZone;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.mission.RallyPoint;
import org.dronemap.core.parameter.OwnersValue;
import org.dronemap.core.parameter.ParameterValue;

/** Commands of each kind. */
public final class CommandSamples {
    private static final Geodetic HERE = new Geodetic(47.4, 8.5);
    private static final MissionItem WAYPOINT = new MissionItem.Waypoint(HERE, Altitude.aboveHome(30), 0);
    private static final FenceZone FENCE =
            new FenceZone.Polygon(true, List.of(HERE, new Geodetic(47.5, 8.5), new Geodetic(47.4, 8.6)));

    private static final List<OwnersValue> KEPT =
            List.of(new OwnersValue("FS_GCS_ENABLE", 0, 1), new OwnersValue("FS_OPTIONS", 0, 16, 18));

    private CommandSamples() {}

    public static Stream<Command> of(CommandKind kind) {
        return switch (kind) {
            case ARM -> Stream.of(new Command.Arm());
            case DISARM -> Stream.of(new Command.Disarm(false), new Command.Disarm(true));
            case SET_MODE -> Stream.of(new Command.SetMode("GUIDED"));
            case TAKE_OFF -> Stream.of(new Command.TakeOff(20));
            case LAND -> Stream.of(new Command.Land());
            case RETURN_TO_LAUNCH -> Stream.of(new Command.ReturnToLaunch());
            case HOLD -> Stream.of(new Command.Hold());
            case EMERGENCY_STOP -> Stream.of(new EmergencyStop());
            case GO_TO -> Stream.of(new Command.GoTo(HERE, Altitude.aboveHome(30)));
            case GO_TO_LOCAL -> Stream.of(new GoToLocal(1, 2, null));
            case TURN -> Stream.of(new Command.Turn(90));
            case UPLOAD_MISSION -> upload();
            case START_MISSION -> Stream.of(new Command.StartMission(CloudLoss.CONTINUE));
            case PAUSE_MISSION -> Stream.of(new Command.PauseMission());
            case CLEAR_MISSION -> Stream.of(new Command.ClearMission());
            case SET_HOME ->
                Stream.of(
                        new Command.SetHome(null, null),
                        new Command.SetHome(HERE, new Altitude(500, Altitude.Reference.AMSL)));
            case READ_HOME -> Stream.of(new ReadHome());
            case TAKE_PICTURE -> Stream.of(new Command.TakePicture());
            case SET_RELAY -> Stream.of(new Command.SetRelay(0, RelaySetting.TOGGLE));
            case READ_PARAMETERS -> Stream.of(new Command.ReadParameters());
            case SET_PARAMETERS -> Stream.of(new Command.SetParameters(List.of(new ParameterValue("RTL_ALT", 1_500))));
            case SET_RETURN_HEIGHT -> Stream.of(new SetReturnHeight(30, true));
            case RETURN_ON_LOSS -> Stream.of(new ReturnOnLoss());
            case SET_CLOUD_LOSS -> Stream.of(new SetCloudLoss(20, KEPT, new Agreeing()));
            case PUT_BACK -> Stream.of(new PutBack(KEPT, new Agreeing()));
            case READ_LOGS -> Stream.of(new ReadLogs());
            case DOWNLOAD_LOG -> Stream.of(new Command.DownloadLog(new VehicleLog(1, null, 20_000), new Swallowing()));
            case READ_FENCE -> Stream.of(new ReadFence());
            case SET_FENCE -> Stream.of(new Command.SetFence(List.of(FENCE)));
            case READ_RALLY_POINTS -> Stream.of(new ReadRallyPoints());
            case SET_RALLY_POINTS -> Stream.of(new Command.SetRallyPoints(List.of(new RallyPoint(HERE, 30))));
            case READ_MAP -> Stream.of(new ReadMap());
        };
    }

    private static Stream<Command> upload() {
        return Stream.of(
                new Command.UploadMission(new Mission(List.of(new MissionItem.TakeOff(20), WAYPOINT, WAYPOINT))));
    }

    /** Keeps nothing, and says that it does. */
    private static final class Agreeing implements OwnersKeeper {
        @Override
        public double returnMeters(double owners) {
            return owners + 5;
        }

        @Override
        public CompletableFuture<Void> keep(Plan plan) {
            return CompletableFuture.completedFuture(null);
        }

        @Override
        public void leftAlone(List<ParameterValue> shown) {
            // Nobody asks.
        }
    }

    /** Takes every piece of a log and keeps none. */
    private static final class Swallowing implements LogSink {
        private State state = State.OPEN;

        @Override
        public BitSet kept() {
            state = State.OPEN;
            return new BitSet();
        }

        @Override
        public boolean put(int piece, byte[] bytes) {
            return true;
        }

        @Override
        public boolean complete(long sizeBytes) {
            state = State.WRITTEN;
            return true;
        }

        @Override
        public void interrupted() {
            // Nothing was kept that could be gone on with.
        }

        @Override
        public State state() {
            return state;
        }
    }
}
