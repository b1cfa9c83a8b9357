package org.dronemap.proxy.mavlink.translate;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronemap.core.command.ChangeSpeed;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.RestoreParameters;
import org.dronemap.core.command.SetCloudLossAction;
import org.dronemap.core.command.SetFence;
import org.dronemap.core.command.SetRallyPoints;
import org.dronemap.core.command.SetReturnHeight;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.proxy.mavlink.procedure.CommandExchange;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.ExchangeSequence;
import org.dronemap.proxy.mavlink.procedure.MavCommandRequest;
import org.dronemap.proxy.mavlink.procedure.MavlinkTarget;
import org.dronemap.proxy.mavlink.procedure.ParameterUpdateExchange;
import org.dronemap.proxy.mavlink.procedure.SetCurrentItemExchange;
import org.jspecify.annotations.Nullable;

/** The adapter for PX4 vehicles: translates commands into exchanges that suit PX4's modes and altitudes. */
final class Px4Adapter implements AutopilotAdapter {
    private static final int NAV_TAKEOFF = 22;
    private static final int FRAME_GLOBAL_INT = 5;
    private static final int AUTO_MAIN_MODE = 4;
    private static final int COM_DLL_EXCEPT_MISSION = 1;
    private static final String LOITER = "LOITER";
    private static final String MISSION = "MISSION";
    private static final String RTL = "RTL";
    private static final String LAND = "LAND";
    private static final Map<String, Mode> MODES = modesByName();
    private static final Map<String, Steering> STEERING = Map.ofEntries(
            Map.entry("MANUAL", Steering.STICKS),
            Map.entry("STABILIZED", Steering.STICKS),
            Map.entry("ACRO", Steering.STICKS),
            Map.entry("RATTITUDE", Steering.STICKS),
            Map.entry("ALTCTL", Steering.STICKS),
            Map.entry("POSCTL", Steering.STICKS),
            Map.entry(LOITER, Steering.ORDERS),
            Map.entry("OFFBOARD", Steering.ORDERS),
            Map.entry(MISSION, Steering.MISSION),
            Map.entry(RTL, Steering.HOME),
            Map.entry(LAND, Steering.SAFETY));
    private static final Map<Steering, String> USUAL = Map.of(
            Steering.STICKS, "POSCTL",
            Steering.ORDERS, LOITER,
            Steering.MISSION, MISSION,
            Steering.HOME, RTL,
            Steering.SAFETY, LAND);
    /** It is not armed on its way home or down, and waits for orders in the other. */
    private static final Map<String, String> ARMING = Map.of(RTL, LOITER, LAND, LOITER);

    private static final String NO_HOME =
            "The vehicle has not told its home position yet, so heights above home are not known; wait for its GPS.";

    private static final ReturnHeightExchanges.Setting RETURN_HEIGHT =
            ReturnHeightExchanges.Setting.of(new ReturnHeightExchanges.Name("RTL_RETURN_ALT", 1));
    /** It does nothing, or holds. */
    private static final CloudLossExchanges.Setting CLOUD_LOSS =
            new CloudLossExchanges.Setting("NAV_DLL_ACT", Set.of(0, 1), 2, true);

    private static final Set<Capability> ALWAYS = Set.of(
            Capability.ARM,
            Capability.DISARM,
            Capability.SET_MODE,
            Capability.RETURN_TO_LAUNCH,
            Capability.HOLD,
            Capability.GO_TO,
            Capability.UPLOAD_MISSION,
            Capability.START_MISSION,
            Capability.PAUSE_MISSION,
            Capability.CLEAR_MISSION,
            Capability.TAKE_PICTURE,
            Capability.READ_PARAMETERS,
            Capability.SET_PARAMETERS,
            Capability.READ_LOGS,
            Capability.FENCE,
            Capability.RALLY_POINTS,
            Capability.SET_HOME,
            Capability.READ_HOME);

    private final VehicleKind kind;

    /** The two bytes of custom_mode that count. */
    private record Mode(int main, int sub) {}

    Px4Adapter(int type) {
        kind = VehicleType.kind(type);
    }

    private static Map<String, Mode> modesByName() {
        Map<String, Mode> modes = new LinkedHashMap<>();
        modes.put("MANUAL", new Mode(1, 0));
        modes.put("STABILIZED", new Mode(7, 0));
        modes.put("ACRO", new Mode(5, 0));
        modes.put("RATTITUDE", new Mode(8, 0));
        modes.put("ALTCTL", new Mode(2, 0));
        modes.put("POSCTL", new Mode(3, 0));
        modes.put(LOITER, new Mode(AUTO_MAIN_MODE, 3));
        modes.put(MISSION, new Mode(AUTO_MAIN_MODE, 4));
        modes.put(RTL, new Mode(AUTO_MAIN_MODE, 5));
        modes.put(LAND, new Mode(AUTO_MAIN_MODE, 6));
        modes.put("RTGS", new Mode(AUTO_MAIN_MODE, 7));
        modes.put("FOLLOWME", new Mode(AUTO_MAIN_MODE, 8));
        modes.put("OFFBOARD", new Mode(6, 0));
        modes.put("TAKEOFF", new Mode(AUTO_MAIN_MODE, 2));
        return modes;
    }

    @Override
    public String family() {
        return "PX4";
    }

    @Override
    public String vehicle() {
        return switch (kind) {
            case MULTICOPTER, HELICOPTER -> "PX4 copter";
            case FIXED_WING -> "PX4 plane";
            case VTOL -> "PX4 VTOL";
            case ROVER, BOAT -> "PX4 rover";
            case SUBMARINE -> "PX4 submarine";
            case AIRSHIP -> "PX4 airship";
            case UNKNOWN -> "PX4";
        };
    }

    @Override
    public String modeName(Heartbeat heartbeat) {
        int main = (int) (heartbeat.customMode() >> 16) & 0xFF;
        int sub = (int) (heartbeat.customMode() >> 24) & 0xFF;
        // Only AUTO is told apart by its sub mode; the others are what their main mode says.
        Mode told = new Mode(main, main == AUTO_MAIN_MODE ? sub : 0);
        return MODES.entrySet().stream()
                .filter(entry -> entry.getValue().equals(told))
                .map(Map.Entry::getKey)
                .findFirst()
                .orElse("Mode(" + main + "." + sub + ")");
    }

    @Override
    public List<String> modes() {
        return List.copyOf(MODES.keySet());
    }

    @Override
    public Capabilities capabilities() {
        return Capabilities.of(can(), modes(), STEERING, USUAL, ARMING).with(MissionAbilityTable.px4(kind));
    }

    /** What is not here it cannot. */
    private Set<Capability> can() {
        EnumSet<Capability> can = EnumSet.copyOf(ALWAYS);
        if (kind != VehicleKind.ROVER && kind != VehicleKind.BOAT && kind != VehicleKind.SUBMARINE) {
            can.add(Capability.TAKE_OFF);
            can.add(Capability.LAND);
        }
        if (kind != VehicleKind.UNKNOWN && kind != VehicleKind.SUBMARINE) {
            can.add(Capability.CHANGE_SPEED);
        }
        return can;
    }

    @Override
    public boolean parametersAsBits() {
        return true;
    }

    @Override
    public Optional<String> missionItemLoss(MissionItemInt item) {
        return MissionItemLoss.of(item, form(0, 0));
    }

    @Override
    public int itemsBeforeMission() {
        return 0;
    }

    /** PX4 says ACTIVE as soon as it is armed: that tells nothing about the air. */
    @Override
    public @Nullable FlightPhase phase(Heartbeat heartbeat) {
        return null;
    }

    @Override
    public Exchange exchangeFor(Command command, CommandContext cockpit) {
        return switch (command.kind()) {
            case SET_MODE -> mode(cockpit, ((Command.SetMode) command).mode());
            case TAKE_OFF -> takeOff(cockpit, (Command.TakeOff) command);
            case LAND -> mode(cockpit, LAND);
            case RETURN_TO_LAUNCH -> mode(cockpit, RTL);
            case HOLD, PAUSE_MISSION -> mode(cockpit, LOITER);
            case GO_TO -> goTo(cockpit, (Command.GoTo) command);
            case CHANGE_SPEED -> SpeedExchanges.change(cockpit, (ChangeSpeed) command, kind);
            case UPLOAD_MISSION ->
                upload(cockpit, ((Command.UploadMission) command).mission().items());
            case START_MISSION -> start(cockpit, (Command.StartMission) command);
            case CLEAR_MISSION -> new MissionExchanges(cockpit, 0).clear();
            case SET_RETURN_HEIGHT ->
                ReturnHeightExchanges.set(cockpit, (SetReturnHeight) command, kind, RETURN_HEIGHT);
            case RETURN_ON_LOSS -> CloudLossExchanges.comeHome(cockpit, kind, CLOUD_LOSS);
            case SET_CLOUD_LOSS ->
                CloudLossExchanges.set(
                        cockpit, (SetCloudLossAction) command, policy(((SetCloudLossAction) command).afterSeconds()));
            case PUT_BACK -> CloudLossExchanges.putBack(cockpit, (RestoreParameters) command);
            case ARM -> BasicExchanges.arm(cockpit, capabilities());
            case DISARM -> BasicExchanges.disarm(cockpit, ((Command.Disarm) command).force());
            case TAKE_PICTURE -> BasicExchanges.picture(cockpit);
            case SET_HOME -> HomeExchanges.set(cockpit, (Command.SetHome) command);
            case READ_HOME -> HomeExchanges.read(cockpit);
            case READ_PARAMETERS -> TransferExchanges.readParameters(cockpit);
            case SET_PARAMETERS -> TransferExchanges.set(cockpit, (Command.SetParameters) command);
            case READ_LOGS -> TransferExchanges.readLogs(cockpit);
            case DOWNLOAD_LOG -> TransferExchanges.download(cockpit, (Command.DownloadLog) command);
            case READ_FENCE -> FenceExchanges.readFence(cockpit);
            case SET_FENCE -> FenceExchanges.set(cockpit, (SetFence) command);
            case READ_RALLY_POINTS -> FenceExchanges.readRally(cockpit);
            case SET_RALLY_POINTS -> FenceExchanges.set(cockpit, (SetRallyPoints) command);
            default -> BasicExchanges.cannot(command);
        };
    }

    @Override
    public Optional<Message> steer(Setpoint setpoint, MavlinkTarget target) {
        return new SetpointEncoder(target, kind).encode(setpoint);
    }

    private Exchange upload(CommandContext cockpit, List<MissionItem> mission) {
        return new MissionExchanges(cockpit, 0)
                .upload(
                        mission,
                        MissionCodec.toWire(
                                mission,
                                cockpit.target(),
                                cockpit.status(),
                                form(
                                        cockpit.status().homeLatitudeE7(),
                                        cockpit.status().homeLongitudeE7())));
    }

    private MissionCodec.Form form(int homeLatitudeE7, int homeLongitudeE7) {
        boolean homeTold = homeLatitudeE7 != 0 || homeLongitudeE7 != 0;
        return new MissionCodec.Form(
                false,
                Float.NaN,
                homeTold ? homeLatitudeE7 : Integer.MAX_VALUE,
                homeTold ? homeLongitudeE7 : Integer.MAX_VALUE,
                kind);
    }

    private static Exchange mode(CommandContext cockpit, String name) {
        Mode mode = MODES.get(name);
        return mode == null
                ? BasicExchanges.refuse(OutcomeCode.MODE_UNKNOWN, "This vehicle has no mode " + name + ".")
                : BasicExchanges.mode(cockpit, name, mode.main(), mode.sub(), cockpit.observer());
    }

    private static Exchange takeOff(CommandContext cockpit, Command.TakeOff command) {
        Double home = cockpit.status().homeAltitudeAmslMeters();
        if (home == null) {
            return BasicExchanges.refuse(OutcomeCode.HOME_UNKNOWN, NO_HOME);
        }
        float altitude = (float) (home + command.altitudeMeters());
        float[] parameters = {-1f, 0f, 0f, Float.NaN, Float.NaN, Float.NaN, altitude};
        return new CommandExchange(
                cockpit.target(),
                MavCommandRequest.ofLong(
                        cockpit.target(),
                        NAV_TAKEOFF,
                        parameters,
                        MavCommandRequest.Retry.VERIFY_FIRST,
                        BasicExchanges.climbing(cockpit.status())),
                cockpit.observer());
    }

    private static Exchange goTo(CommandContext cockpit, Command.GoTo command) {
        Double home = cockpit.status().homeAltitudeAmslMeters();
        boolean relative = command.altitude().reference() == Altitude.Reference.HOME;
        if (relative && home == null) {
            return BasicExchanges.refuse(OutcomeCode.HOME_UNKNOWN, NO_HOME);
        }
        double altitude = command.altitude().meters() + (relative && home != null ? home : 0);
        // Without one it goes at its usual speed, whatever it was told before.
        Double speed = cockpit.status().speed();
        CommandInt message = new CommandInt(
                cockpit.target().systemId(),
                cockpit.target().componentId(),
                FRAME_GLOBAL_INT,
                BasicExchanges.DO_REPOSITION,
                0,
                0,
                speed == null ? -1f : speed.floatValue(),
                1f,
                0f,
                Float.NaN,
                MissionCodec.e7(command.point().latitudeDegrees()),
                MissionCodec.e7(command.point().longitudeDegrees()),
                (float) altitude);
        return new CommandExchange(
                cockpit.target(),
                MavCommandRequest.ofInt(message, MavCommandRequest.Retry.REPEATABLE),
                cockpit.observer());
    }

    private @Nullable CloudLossParameters policy(int seconds) {
        return switch (kind) {
            case MULTICOPTER, HELICOPTER -> CloudLossParameterSets.px4(seconds, RETURN_HEIGHT);
            case FIXED_WING, VTOL, ROVER, BOAT -> CloudLossParameterSets.px4(seconds, null);
            case SUBMARINE, AIRSHIP, UNKNOWN -> null;
        };
    }

    private Exchange start(CommandContext cockpit, Command.StartMission start) {
        List<ExchangeSequence.Step> steps = new ArrayList<>();
        if (start.onCloudLoss() != null) {
            boolean goOn = start.onCloudLoss() == MissionCloudLossPolicy.CONTINUE;
            steps.add(BasicExchanges.setParameterStep(
                    cockpit,
                    new ParameterUpdateExchange.Wanted(
                            "COM_DLL_EXCEPT",
                            old -> goOn ? old | COM_DLL_EXCEPT_MISSION : old & ~COM_DLL_EXCEPT_MISSION,
                            true)));
        }
        VehicleStatus status = cockpit.status();
        boolean fromGround = !status.airborne() && !kind.neverFlies();
        boolean resumes = status.resumesMission(0);
        boolean elsewhere = start.anew() || status.currentSeq() > 0;
        if (!fromGround && elsewhere && (start.anew() || !resumes)) {
            steps.add(ExchangeSequence.Step.of(() -> new SetCurrentItemExchange(cockpit.target(), 0, seq -> seq == 0)));
        } else if (!resumes) {
            steps.add(new ExchangeSequence.Step(
                    () -> new SetCurrentItemExchange(cockpit.target(), 0, seq -> seq == 0), any -> true));
        }
        steps.add(ExchangeSequence.Step.of(() -> mode(cockpit, MISSION)));
        return new ExchangeSequence(steps);
    }
}
