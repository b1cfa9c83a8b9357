package org.dronemap.proxy.outlet.uplink;

import java.util.Map;
import java.util.TreeMap;
import org.dronemap.core.command.ChangeSpeed;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.command.RelaySetting;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.mavlink.translate.AutopilotAdapter;
import org.jspecify.annotations.Nullable;

/**
 * Translates a MAVLink command, which a user's own ground station sends at the outlet, into a command of the cloud;
 * kinds that are not in its table are refused. Stateless.
 */
final class ClientCommandReader {
    static final int SET_MODE = 176;
    static final int OPERATOR_CONTROL = 32_100;
    private static final int LAND = 21;
    /** Programs name the place where the vehicle was a moment ago. */
    private static final double SAME_PLACE_METERS = 50;

    private static final int FORCE = 21_196;
    private static final int GLOBAL = 0;
    private static final int RELATIVE = 3;
    private static final int GLOBAL_INT = 5;
    private static final int RELATIVE_INT = 6;
    private static final double E7 = 1e7;
    private static final Map<Integer, Entry> WORDS = words();

    private ClientCommandReader() {}

    /**
     * A client's MAV_CMD together with the heartbeat and state of the drone that it is for.
     *
     * @param command with place in degrees 1e7 and its altitude, whichever message brought it
     * @param heartbeat the autopilot's last one
     * @param state of the drone
     */
    record Context(CommandInt command, Heartbeat heartbeat, DroneState state) {
        private AutopilotAdapter autopilot() {
            return AutopilotAdapter.of(heartbeat);
        }

        private boolean isPx4() {
            return state.identification().autopilot().equals("PX4");
        }
    }

    /** {@code name} as MAVLink has it, without MAV_CMD_. */
    private record Entry(String name, String means, Meaning meaning) {}

    @FunctionalInterface
    private interface Meaning {
        ClientIntent of(Context context);
    }

    static ClientIntent of(Context context) {
        Entry word = WORDS.get(context.command().command());
        if (word == null) {
            return new ClientIntent.Unknown();
        }
        try {
            return word.meaning().of(context);
        } catch (IllegalArgumentException outOfBounds) {
            return new ClientIntent.Denied("This cannot be asked: " + outOfBounds.getMessage() + ".");
        }
    }

    /** What a client is told beside the answer, since the vehicle does not do all of what was asked; null: nothing. */
    static @Nullable String remark(Context asked) {
        CommandInt command = asked.command();
        Position position = asked.state().position();
        Geodetic here = position == null ? null : position.point();
        boolean place = command.command() == LAND
                && command.x() != 0
                && command.y() != 0
                && Math.abs((long) command.x()) <= 90 * E7
                && Math.abs((long) command.y()) <= 180 * E7;
        return place && here != null && Geodesy.distanceMeters(here, point(command)) > SAME_PLACE_METERS
                ? "It lands where it is, not at the place that is named; to land there, fly a mission that ends so."
                : null;
    }

    /** Number and name of each command that passes, with what it becomes, as the guide lists them. */
    static Map<Integer, String> table() {
        Map<Integer, String> table = new TreeMap<>();
        WORDS.forEach((number, word) -> table.put(number, word.name() + ": " + word.means()));
        return table;
    }

    private static Map<Integer, Entry> words() {
        Map<Integer, Entry> words = new TreeMap<>();
        words.put(17, new Entry("NAV_LOITER_UNLIM", "hold", asked -> order(new Command.Hold())));
        words.put(
                20, new Entry("NAV_RETURN_TO_LAUNCH", "returnToLaunch", asked -> order(new Command.ReturnToLaunch())));
        words.put(LAND, new Entry("NAV_LAND", "land", asked -> order(new Command.Land())));
        words.put(22, new Entry("NAV_TAKEOFF", "takeOff", ClientCommandReader::takeOff));
        words.put(115, new Entry("CONDITION_YAW", "turn", ClientCommandReader::turn));
        words.put(SET_MODE, new Entry("DO_SET_MODE", "setMode", ClientCommandReader::mode));
        words.put(178, new Entry("DO_CHANGE_SPEED", "changeSpeed", ClientCommandReader::speed));
        words.put(179, new Entry("DO_SET_HOME", "setHome", ClientCommandReader::home));
        words.put(181, new Entry("DO_SET_RELAY", "setRelay", ClientCommandReader::relay));
        words.put(192, new Entry("DO_REPOSITION", "goTo", ClientCommandReader::goTo));
        words.put(193, new Entry("DO_PAUSE_CONTINUE", "pauseMission, hold", ClientCommandReader::pause));
        words.put(203, new Entry("DO_DIGICAM_CONTROL", "takePicture", asked -> order(new Command.TakePicture())));
        words.put(
                300,
                new Entry(
                        "MISSION_START",
                        "startMission",
                        asked -> order(new Command.StartMission(MissionCloudLossPolicy.CONTINUE))));
        words.put(400, new Entry("COMPONENT_ARM_DISARM", "arm, disarm", ClientCommandReader::arm));
        words.put(410, new Entry("GET_HOME_POSITION", "from the cache", asked -> new ClientIntent.Show(242)));
        words.put(511, new Entry("SET_MESSAGE_INTERVAL", "the usual rate only", ClientCommandReader::rate));
        words.put(512, new Entry("REQUEST_MESSAGE", "from the cache", ClientCommandReader::message));
        words.put(519, new Entry("REQUEST_PROTOCOL_VERSION", "from the cache", asked -> new ClientIntent.Show(300)));
        words.put(
                520,
                new Entry("REQUEST_AUTOPILOT_CAPABILITIES", "from the cache", asked -> new ClientIntent.Show(148)));
        words.put(
                OPERATOR_CONTROL,
                new Entry(
                        "REQUEST_OPERATOR_CONTROL",
                        "takes, asks for, hands over, gives back",
                        ClientCommandReader::control));
        words.put(2000, new Entry("IMAGE_START_CAPTURE", "takePicture", asked -> order(new Command.TakePicture())));
        return words;
    }

    private static ClientIntent message(Context asked) {
        return new ClientIntent.Show(Math.round(asked.command().param1()));
    }

    private static ClientIntent order(Command command) {
        return new ClientIntent.Order(command);
    }

    /** Whether to have it, and whether to give it to whoever asks. */
    private static ClientIntent control(Context asked) {
        float action = asked.command().param1();
        if (action == 0) {
            return new ClientIntent.Release();
        }
        return action == 1
                ? new ClientIntent.Control(asked.command().param2() == 1)
                : new ClientIntent.Denied("Control is asked for with 1, or given back with 0.");
    }

    /** PX4 takes altitudes above the sea, others above home. */
    private static ClientIntent takeOff(Context asked) {
        double height = asked.command().z();
        Home home = asked.state().home();
        if (asked.isPx4()) {
            if (home == null) {
                return new ClientIntent.Denied("Its home is not known yet, so that no altitude can be told.");
            }
            height -= home.altitudeAmslMeters();
        }
        return Double.isNaN(height)
                ? new ClientIntent.Denied("Name an altitude to take off to.")
                : order(new Command.TakeOff(height));
    }

    private static ClientIntent turn(Context asked) {
        CommandInt command = asked.command();
        if (Math.round(command.param4()) != 1) {
            return new ClientIntent.Denied("Only turns from where it looks now pass.");
        }
        return order(new Command.Turn(command.param3() < 0 ? -command.param1() : command.param1()));
    }

    /** By type 0 a copter understands its speed over the ground, and by type 1 a plane something else. */
    private static ClientIntent speed(Context asked) {
        CommandInt command = asked.command();
        int type = Math.round(command.param1());
        VehicleKind kind = asked.state().identification().kind();
        boolean wings = kind == VehicleKind.FIXED_WING || kind == VehicleKind.VTOL;
        if (type != 0 && (type != 1 || wings)) {
            return new ClientIntent.Denied(
                    "Only the speed through the air (0) of planes passes, and that over the ground (1) of others.");
        }
        return command.param3() > 0
                ? new ClientIntent.Denied("A speed passes without a throttle.")
                : order(new ChangeSpeed(command.param2()));
    }

    private static ClientIntent mode(Context asked) {
        CommandInt command = asked.command();
        long custom = Math.round((double) command.param2());
        long number =
                asked.isPx4() && custom < 256 ? custom << 16 | Math.round((double) command.param3()) << 24 : custom;
        return order(new Command.SetMode(modeName(asked, Math.round(command.param1()), number)));
    }

    /** What a vehicle calls a mode that it is told by its numbers. */
    static String modeName(Context asked, int baseMode, long customMode) {
        Heartbeat now = asked.heartbeat();
        return asked.autopilot()
                .modeName(new Heartbeat(
                        now.type(),
                        now.autopilot(),
                        baseMode | 1,
                        customMode,
                        now.systemStatus(),
                        now.mavlinkVersion()));
    }

    private static ClientIntent home(Context asked) {
        if (Math.round(asked.command().param1()) == 1) {
            return order(new Command.SetHome(null, null));
        }
        Altitude altitude = altitude(asked.command());
        return altitude == null
                ? new ClientIntent.Denied("Only altitudes above the sea or above home pass.")
                : order(new Command.SetHome(point(asked.command()), altitude));
    }

    private static ClientIntent relay(Context asked) {
        CommandInt command = asked.command();
        int setting = Math.round(command.param2());
        if (setting != 0 && setting != 1) {
            return new ClientIntent.Denied("A relay is switched 0 (off) or 1 (on).");
        }
        return order(
                new Command.SetRelay(Math.round(command.param1()), setting == 1 ? RelaySetting.ON : RelaySetting.OFF));
    }

    private static ClientIntent goTo(Context asked) {
        Altitude altitude = altitude(asked.command());
        return altitude == null
                ? new ClientIntent.Denied("Name an altitude above the sea or above home.")
                : order(new Command.GoTo(point(asked.command()), altitude));
    }

    private static ClientIntent pause(Context asked) {
        if (Math.round(asked.command().param1()) != 0) {
            return new ClientIntent.Denied("Start the mission to continue it.");
        }
        DroneState state = asked.state();
        boolean onMission = state.capabilities()
                .steering(state.mode())
                .filter(Steering.MISSION::equals)
                .isPresent();
        return order(onMission ? new Command.PauseMission() : new Command.Hold());
    }

    private static ClientIntent arm(Context asked) {
        boolean force = Math.round(asked.command().param2()) == FORCE;
        if (Math.round(asked.command().param1()) == 1) {
            return force ? new ClientIntent.Denied("Arming by force does not pass.") : order(new Command.Arm());
        }
        return order(new Command.Disarm(force));
    }

    private static ClientIntent rate(Context asked) {
        return asked.command().param2() == 0
                ? new ClientIntent.Granted()
                : new ClientIntent.Denied("How often messages come is the cloud's to say.");
    }

    private static Geodetic point(CommandInt command) {
        return new Geodetic(command.x() / E7, command.y() / E7);
    }

    /** Null for altitudes that are measured from the ground, or not a number. */
    static @Nullable Altitude altitude(int frame, double meters) {
        if (Double.isNaN(meters)) {
            return null;
        }
        return switch (frame) {
            case GLOBAL, GLOBAL_INT -> new Altitude(meters, Altitude.Reference.AMSL);
            case RELATIVE, RELATIVE_INT -> new Altitude(meters, Altitude.Reference.HOME);
            default -> null;
        };
    }

    private static @Nullable Altitude altitude(CommandInt command) {
        return altitude(command.frame(), command.z());
    }
}
