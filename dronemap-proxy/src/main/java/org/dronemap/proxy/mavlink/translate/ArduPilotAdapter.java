package org.dronemap.proxy.mavlink.translate;

import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.dronemap.core.command.ChangeSpeed;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.RestoreParameters;
import org.dronemap.core.command.SetCloudLossAction;
import org.dronemap.core.command.SetFence;
import org.dronemap.core.command.SetRallyPoints;
import org.dronemap.core.command.SetReturnHeight;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.EkfStatusReport;
import org.dronemap.mavlink.message.ExtendedSysState;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.Wind;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.ExchangeObserver;
import org.dronemap.proxy.mavlink.procedure.ExchangeSequence;
import org.dronemap.proxy.mavlink.procedure.FallbackExchange;
import org.dronemap.proxy.mavlink.procedure.MavlinkTarget;
import org.jspecify.annotations.Nullable;

/** The adapter for ArduPilot vehicles: translates commands into exchanges that suit ArduPilot's modes and missions. */
final class ArduPilotAdapter implements AutopilotAdapter {
    private static final String AUTO = "AUTO";
    private static final String GUIDED = "GUIDED";
    private static final String RTL = "RTL";
    private static final int VTOL_STATE_UNDEFINED = 0;
    private static final int STANDBY = 3;
    private static final int ACTIVE = 4;
    static final int HOME_ITEMS = 1;
    private static final long WIND_MICROS = 5_000_000;
    private static final long ESTIMATOR_MICROS = 1_000_000;

    /** In m since ArduCopter 4.7, in cm before. */
    private static final ReturnHeightExchanges.Setting RETURN_HEIGHT = ReturnHeightExchanges.Setting.of(
            new ReturnHeightExchanges.Name("RTL_ALT_M", 1), new ReturnHeightExchanges.Name("RTL_ALT", 100));

    private static final CloudLossExchanges.Setting CLOUD_LOSS =
            new CloudLossExchanges.Setting("FS_GCS_ENABLE", Set.of(0), 1, false);

    private static final Set<Capability> ALWAYS = Set.of(
            Capability.ARM,
            Capability.DISARM,
            Capability.SET_MODE,
            Capability.TAKE_PICTURE,
            Capability.SET_RELAY,
            Capability.READ_PARAMETERS,
            Capability.SET_PARAMETERS,
            Capability.READ_LOGS,
            Capability.FENCE,
            Capability.RALLY_POINTS,
            Capability.SET_HOME,
            Capability.READ_HOME);

    private static final Set<Capability> IN_AUTO = Set.of(
            Capability.UPLOAD_MISSION,
            Capability.CLEAR_MISSION,
            Capability.START_MISSION,
            Capability.HOLD,
            Capability.PAUSE_MISSION);

    private final VehicleKind kind;
    private final ArduPilotModeTable table;

    ArduPilotAdapter(int type) {
        kind = VehicleType.kind(type);
        table = switch (kind) {
            case MULTICOPTER, HELICOPTER -> ArduPilotModeTable.COPTER;
            case FIXED_WING, VTOL -> ArduPilotModeTable.PLANE;
            case ROVER, BOAT -> ArduPilotModeTable.ROVER;
            case SUBMARINE -> ArduPilotModeTable.SUB;
            case AIRSHIP -> ArduPilotModeTable.BLIMP;
            case UNKNOWN -> ArduPilotModeTable.EMPTY;
        };
    }

    /** A QuadPlane calls itself a fixed wing unless its owner has set Q_MAV_TYPE; only it has a state of that. */
    @Override
    public OptionalInt typeBy(ExtendedSysState state) {
        return kind == VehicleKind.FIXED_WING && state.vtolState() != VTOL_STATE_UNDEFINED
                ? OptionalInt.of(VehicleType.VTOL_FIXED_ROTOR)
                : OptionalInt.empty();
    }

    @Override
    public String family() {
        return "ArduPilot";
    }

    @Override
    public String vehicle() {
        return switch (kind) {
            case MULTICOPTER, HELICOPTER -> "ArduCopter";
            case FIXED_WING, VTOL -> "ArduPlane";
            case ROVER, BOAT -> "ArduRover";
            case SUBMARINE -> "ArduSub";
            case AIRSHIP -> "Blimp";
            case UNKNOWN -> "ArduPilot";
        };
    }

    @Override
    public String modeName(Heartbeat heartbeat) {
        String name = (heartbeat.baseMode() & 1) != 0 ? table.name(heartbeat.customMode()) : null;
        return name != null ? name : UnknownAutopilotAdapter.unnamed(heartbeat);
    }

    @Override
    public Map<Integer, Long> ownMessages() {
        return kind == VehicleKind.SUBMARINE
                ? Map.of(Wind.ID, WIND_MICROS)
                : Map.of(Wind.ID, WIND_MICROS, EkfStatusReport.ID, ESTIMATOR_MICROS);
    }

    @Override
    public List<String> modes() {
        return table.names();
    }

    @Override
    public Capabilities capabilities() {
        return Capabilities.of(can(), modes(), table.steering(), table.usual(), table.arming())
                .with(MissionAbilityTable.arduPilot(kind));
    }

    /** What is not here it cannot. */
    private Set<Capability> can() {
        boolean copter = table == ArduPilotModeTable.COPTER;
        boolean led = copter || table == ArduPilotModeTable.ROVER;
        Map<Capability, Boolean> by = Map.of(
                Capability.GO_TO,
                table.has(GUIDED),
                Capability.RETURN_TO_LAUNCH,
                table.has(RTL),
                Capability.LAND,
                kind != VehicleKind.FIXED_WING && (table.has("LAND") || table.has("QLAND")),
                Capability.TAKE_OFF,
                copter || kind == VehicleKind.VTOL,
                Capability.TURN,
                copter,
                Capability.VELOCITY,
                led,
                Capability.TRACK,
                led,
                Capability.STICKS,
                led || table == ArduPilotModeTable.PLANE || table == ArduPilotModeTable.SUB);
        EnumSet<Capability> can = EnumSet.copyOf(ALWAYS);
        by.forEach((capability, does) -> {
            if (does) {
                can.add(capability);
            }
        });
        if (table.has(AUTO)) {
            can.addAll(IN_AUTO);
        }
        if (table.has(GUIDED) && table.has(AUTO)) {
            can.add(Capability.CHANGE_SPEED);
        }
        return can;
    }

    @Override
    public boolean parametersAsBits() {
        return false;
    }

    @Override
    public Optional<String> missionItemLoss(MissionItemInt item) {
        return MissionItemLoss.of(item, form());
    }

    @Override
    public int itemsBeforeMission() {
        return HOME_ITEMS;
    }

    /** Copter and Plane call standing on the ground STANDBY and flying ACTIVE; the others mean something else. */
    @Override
    public @Nullable FlightPhase phase(Heartbeat heartbeat) {
        if (table != ArduPilotModeTable.COPTER && table != ArduPilotModeTable.PLANE) {
            return null;
        }
        return switch (heartbeat.systemStatus()) {
            case STANDBY -> FlightPhase.ON_GROUND;
            case ACTIVE -> FlightPhase.IN_AIR;
            default -> null;
        };
    }

    @Override
    public Exchange exchangeFor(Command command, CommandContext cockpit) {
        return switch (command.kind()) {
            case SET_MODE -> mode(cockpit, ((Command.SetMode) command).mode(), cockpit.observer());
            case TAKE_OFF -> GuidedExchanges.takeOff(cockpit, guided(cockpit), (Command.TakeOff) command);
            case LAND -> mode(cockpit, kind == VehicleKind.VTOL ? "QLAND" : "LAND", cockpit.observer());
            case RETURN_TO_LAUNCH -> returnToLaunch(cockpit);
            case HOLD, PAUSE_MISSION -> hold(cockpit, cockpit.observer());
            case GO_TO -> GuidedExchanges.goTo(cockpit, guided(cockpit), (Command.GoTo) command, kind);
            case CHANGE_SPEED -> SpeedExchanges.ofArduPilot(cockpit, (ChangeSpeed) command, kind);
            case TURN -> GuidedExchanges.turn(cockpit, guided(cockpit), ((Command.Turn) command).degrees());
            case UPLOAD_MISSION ->
                upload(cockpit, ((Command.UploadMission) command).mission().items());
            case START_MISSION ->
                MissionStartExchanges.begin(
                        cockpit, (Command.StartMission) command, kind, observer -> mode(cockpit, AUTO, observer));
            case CLEAR_MISSION -> new MissionExchanges(cockpit, HOME_ITEMS).clear();
            case SET_RELAY -> BasicExchanges.relay(cockpit, (Command.SetRelay) command);
            case SET_RETURN_HEIGHT ->
                ReturnHeightExchanges.set(cockpit, (SetReturnHeight) command, kind, RETURN_HEIGHT);
            case RETURN_ON_LOSS -> CloudLossExchanges.comeHome(cockpit, kind, CLOUD_LOSS);
            case SET_CLOUD_LOSS -> setCloudLoss(cockpit, (SetCloudLossAction) command);
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
            case SET_RALLY_POINTS -> FenceExchanges.setWholeMeters(cockpit, (SetRallyPoints) command);
            default -> BasicExchanges.cannot(command);
        };
    }

    @Override
    public Optional<Message> steer(Setpoint setpoint, MavlinkTarget target) {
        return new SetpointEncoder(target, kind).encode(setpoint);
    }

    private Exchange setCloudLoss(CommandContext cockpit, SetCloudLossAction command) {
        return CloudLossExchanges.set(cockpit, command, policy(command.afterSeconds()));
    }

    private Exchange mode(CommandContext cockpit, String name, ExchangeObserver observer) {
        return table.number(name)
                .map(number -> PositionlessModes.explained(
                        cockpit, BasicExchanges.mode(cockpit, name, number, 0f, observer), kind, name))
                .orElseGet(() ->
                        BasicExchanges.refuse(OutcomeCode.MODE_UNKNOWN, "This vehicle has no mode " + name + "."));
    }

    /** BRAKE needs no pilot's throttle; where it is not to be had, the mode that every vehicle of the kind knows. */
    private Exchange hold(CommandContext cockpit, ExchangeObserver observer) {
        return switch (kind) {
            case MULTICOPTER, HELICOPTER -> either(cockpit, "BRAKE", "LOITER", observer);
            case ROVER, BOAT, AIRSHIP -> mode(cockpit, "HOLD", observer);
            case SUBMARINE -> either(cockpit, "POSHOLD", "ALT_HOLD", observer);
            case VTOL -> either(cockpit, "QLOITER", "LOITER", observer);
            case FIXED_WING, UNKNOWN -> mode(cockpit, "LOITER", observer);
        };
    }

    private Exchange either(CommandContext cockpit, String first, String second, ExchangeObserver observer) {
        return new FallbackExchange(
                mode(cockpit, first, observer), ArduPilotAdapter::isOtherwise, () -> mode(cockpit, second, observer));
    }

    /** Whether the vehicle has said that it does not: who is silent is not asked for something else. */
    private static boolean isOtherwise(Outcome outcome) {
        return switch (outcome.kind()) {
            case REFUSED, FAILED -> true;
            case SUCCEEDED, TIMED_OUT, SUPERSEDED, UNKNOWN -> false;
        };
    }

    private ExchangeSequence.Step guided(CommandContext cockpit) {
        return ExchangeSequence.Step.when(
                () -> !cockpit.status().inMode(GUIDED), () -> mode(cockpit, GUIDED, ExchangeObserver.NONE));
    }

    /** ArduPilot overwrites item by item: one that flies its mission holds first. */
    private Exchange upload(CommandContext cockpit, List<MissionItem> mission) {
        return new ExchangeSequence(List.of(
                ExchangeSequence.Step.when(
                        () -> cockpit.status().armed() && cockpit.status().inMode(AUTO),
                        () -> hold(cockpit, ExchangeObserver.NONE)),
                ExchangeSequence.Step.of(() -> new MissionExchanges(cockpit, HOME_ITEMS)
                        .inAnyOrder()
                        .uploadInParts(
                                mission, MissionCodec.toWire(mission, cockpit.target(), cockpit.status(), form()))),
                // In the air nothing is to wait for that; its start tells it then.
                ExchangeSequence.Step.when(
                        () -> !cockpit.status().armed(), () -> new ExchangeSequence(OwnFenceExchanges.warn(cockpit)))));
    }

    private MissionCodec.Form form() {
        return new MissionCodec.Form(true, 0f, 0, 0, kind);
    }

    private Exchange returnToLaunch(CommandContext cockpit) {
        return switch (kind) {
            case FIXED_WING -> PlaneReturnExchanges.begin(cockpit, () -> mode(cockpit, RTL, cockpit.observer()));
            case VTOL -> mode(cockpit, "QRTL", cockpit.observer());
            case MULTICOPTER, HELICOPTER, ROVER, BOAT, SUBMARINE, AIRSHIP, UNKNOWN ->
                mode(cockpit, RTL, cockpit.observer());
        };
    }

    private @Nullable CloudLossParameters policy(int seconds) {
        return switch (kind) {
            case MULTICOPTER, HELICOPTER -> CloudLossParameterSets.copter(seconds, RETURN_HEIGHT);
            case FIXED_WING -> CloudLossParameterSets.plane(seconds);
            case VTOL -> CloudLossParameterSets.quadPlane(seconds);
            case ROVER, BOAT -> CloudLossParameterSets.rover(seconds);
            case SUBMARINE, AIRSHIP, UNKNOWN -> null;
        };
    }
}
