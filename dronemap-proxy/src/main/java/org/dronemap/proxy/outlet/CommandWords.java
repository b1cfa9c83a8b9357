package org.dronemap.proxy.outlet;

import java.util.Map;
import java.util.TreeMap;
import org.dronemap.core.command.CloudLoss;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.RelaySetting;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.mavlink.translate.Autopilot;
import org.jspecify.annotations.Nullable;

/** The MAVLink commands that pass, and what they come to; all others do not. Stateless. */
final class CommandWords {
    static final int SET_MODE = 176;
    static final int OPERATOR_CONTROL = 32_100;
    private static final int FORCE = 21_196;
    private static final int GLOBAL = 0;
    private static final int RELATIVE = 3;
    private static final int GLOBAL_INT = 5;
    private static final int RELATIVE_INT = 6;
    private static final double E7 = 1e7;
    private static final Map<Integer, Word> WORDS = words();

    private CommandWords() {}

    /**
     * A client's MAV_CMD together with the heartbeat and state of the drone that it is for.
     *
     * @param command with place in degrees 1e7 and its altitude, whichever message brought it
     * @param heartbeat the autopilot's last one
     * @param state of the drone
     */
    record Context(CommandInt command, Heartbeat heartbeat, DroneState state) {
        private Autopilot autopilot() {
            return Autopilot.of(heartbeat);
        }

        private boolean isPx4() {
            return state.identification().autopilot().equals("PX4");
        }
    }

    /** {@code name} as MAVLink has it, without MAV_CMD_. */
    private record Word(String name, String means, Meaning meaning) {}

    @FunctionalInterface
    private interface Meaning {
        Wish of(Context context);
    }

    static Wish of(Context context) {
        Word word = WORDS.get(context.command().command());
        if (word == null) {
            return new Wish.Unknown();
        }
        try {
            return word.meaning().of(context);
        } catch (IllegalArgumentException outOfBounds) {
            return new Wish.Denied("This cannot be asked: " + outOfBounds.getMessage() + ".");
        }
    }

    /** Number and name of each command that passes, with what it becomes, as the guide lists them. */
    static Map<Integer, String> table() {
        Map<Integer, String> table = new TreeMap<>();
        WORDS.forEach((number, word) -> table.put(number, word.name() + ": " + word.means()));
        return table;
    }

    private static Map<Integer, Word> words() {
        Map<Integer, Word> words = new TreeMap<>();
        words.put(17, new Word("NAV_LOITER_UNLIM", "hold", asked -> order(new Command.Hold())));
        words.put(20, new Word("NAV_RETURN_TO_LAUNCH", "returnToLaunch", asked -> order(new Command.ReturnToLaunch())));
        words.put(21, new Word("NAV_LAND", "land", asked -> order(new Command.Land())));
        words.put(22, new Word("NAV_TAKEOFF", "takeOff", CommandWords::takeOff));
        words.put(115, new Word("CONDITION_YAW", "turn", CommandWords::turn));
        words.put(SET_MODE, new Word("DO_SET_MODE", "setMode", CommandWords::mode));
        words.put(179, new Word("DO_SET_HOME", "setHome", CommandWords::home));
        words.put(181, new Word("DO_SET_RELAY", "setRelay", CommandWords::relay));
        words.put(192, new Word("DO_REPOSITION", "goTo", CommandWords::goTo));
        words.put(193, new Word("DO_PAUSE_CONTINUE", "pauseMission, hold", CommandWords::pause));
        words.put(203, new Word("DO_DIGICAM_CONTROL", "takePicture", asked -> order(new Command.TakePicture())));
        words.put(
                300,
                new Word(
                        "MISSION_START", "startMission", asked -> order(new Command.StartMission(CloudLoss.CONTINUE))));
        words.put(400, new Word("COMPONENT_ARM_DISARM", "arm, disarm", CommandWords::arm));
        words.put(410, new Word("GET_HOME_POSITION", "from the cache", asked -> new Wish.Show(242)));
        words.put(511, new Word("SET_MESSAGE_INTERVAL", "the usual rate only", CommandWords::rate));
        words.put(
                512,
                new Word(
                        "REQUEST_MESSAGE",
                        "from the cache",
                        asked -> new Wish.Show(Math.round(asked.command().param1()))));
        words.put(519, new Word("REQUEST_PROTOCOL_VERSION", "from the cache", asked -> new Wish.Show(300)));
        words.put(520, new Word("REQUEST_AUTOPILOT_CAPABILITIES", "from the cache", asked -> new Wish.Show(148)));
        words.put(
                OPERATOR_CONTROL,
                new Word("REQUEST_OPERATOR_CONTROL", "takes, asks for, hands over, gives back", CommandWords::control));
        words.put(2000, new Word("IMAGE_START_CAPTURE", "takePicture", asked -> order(new Command.TakePicture())));
        return words;
    }

    private static Wish order(Command command) {
        return new Wish.Order(command);
    }

    /** Whether to have it, and whether to give it to whoever asks. */
    private static Wish control(Context asked) {
        float action = asked.command().param1();
        if (action == 0) {
            return new Wish.Release();
        }
        return action == 1
                ? new Wish.Control(asked.command().param2() == 1)
                : new Wish.Denied("Control is asked for with 1, or given back with 0.");
    }

    /** PX4 takes altitudes above the sea, others above home. */
    private static Wish takeOff(Context asked) {
        double height = asked.command().z();
        Home home = asked.state().home();
        if (asked.isPx4()) {
            if (home == null) {
                return new Wish.Denied("Its home is not known yet, so that no altitude can be told.");
            }
            height -= home.altitudeAmslMeters();
        }
        return Double.isNaN(height)
                ? new Wish.Denied("Name an altitude to take off to.")
                : order(new Command.TakeOff(height));
    }

    private static Wish turn(Context asked) {
        CommandInt command = asked.command();
        if (Math.round(command.param4()) != 1) {
            return new Wish.Denied("Only turns from where it looks now pass.");
        }
        return order(new Command.Turn(command.param3() < 0 ? -command.param1() : command.param1()));
    }

    private static Wish mode(Context asked) {
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

    private static Wish home(Context asked) {
        if (Math.round(asked.command().param1()) == 1) {
            return order(new Command.SetHome(null, null));
        }
        Altitude altitude = altitude(asked.command());
        return altitude == null
                ? new Wish.Denied("Only altitudes above the sea or above home pass.")
                : order(new Command.SetHome(point(asked.command()), altitude));
    }

    private static Wish relay(Context asked) {
        CommandInt command = asked.command();
        int setting = Math.round(command.param2());
        if (setting != 0 && setting != 1) {
            return new Wish.Denied("A relay is switched 0 (off) or 1 (on).");
        }
        return order(
                new Command.SetRelay(Math.round(command.param1()), setting == 1 ? RelaySetting.ON : RelaySetting.OFF));
    }

    private static Wish goTo(Context asked) {
        Altitude altitude = altitude(asked.command());
        return altitude == null
                ? new Wish.Denied("Name an altitude above the sea or above home.")
                : order(new Command.GoTo(point(asked.command()), altitude));
    }

    private static Wish pause(Context asked) {
        if (Math.round(asked.command().param1()) != 0) {
            return new Wish.Denied("Start the mission to continue it.");
        }
        DroneState state = asked.state();
        boolean onMission = state.capabilities()
                .steering(state.mode())
                .filter(Steering.MISSION::equals)
                .isPresent();
        return order(onMission ? new Command.PauseMission() : new Command.Hold());
    }

    private static Wish arm(Context asked) {
        boolean force = Math.round(asked.command().param2()) == FORCE;
        if (Math.round(asked.command().param1()) == 1) {
            return force ? new Wish.Denied("Arming by force does not pass.") : order(new Command.Arm());
        }
        return order(new Command.Disarm(force));
    }

    private static Wish rate(Context asked) {
        return asked.command().param2() == 0
                ? new Wish.Granted()
                : new Wish.Denied("How often messages come is the cloud's to say.");
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
