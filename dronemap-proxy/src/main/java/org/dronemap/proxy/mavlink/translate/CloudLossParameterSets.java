package org.dronemap.proxy.mavlink.translate;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.dronemap.core.drone.CloudLossAction;
import org.dronemap.core.drone.CloudLossAction.AtHome;
import org.dronemap.proxy.mavlink.translate.CloudLossParameters.Setting;
import org.jspecify.annotations.Nullable;

/**
 * The parameter values by which each kind of vehicle returns or lands by itself when it loses the ground station. Only
 * what concerns nothing but the ground station gets its time; what a vehicle does without its remote control as well is
 * made stricter, never laxer.
 */
final class CloudLossParameterSets {
    private static final String HOME = "it returns home";
    private static final String DOWN = "it lands";
    private static final String GOES_ON = "it goes on";
    /** Firmware that cannot be told when waits so long. */
    private static final double FIXED_SECONDS = 5;

    private static final String FIXED = "Its time cannot be set.";
    private static final String ALSO_RC = "It does the same when it loses its remote control.";
    private static final String CIRCLES =
            "By RTL_AUTOLAND it does not land there by itself, whatever its mission: it circles.";
    private static final String OWNERS_LANDING = "Whether it lands there is as its owner has set RTL_AUTOLAND.";
    private static final String OWNERS_ROTORS =
            "Whether it lands there on its rotors is as its owner has set Q_RTL_MODE.";
    private static final String AUTOLAND = "RTL_AUTOLAND";
    private static final String Q_ENABLE = "Q_ENABLE";
    private static final String Q_RTL_MODE = "Q_RTL_MODE";
    /** Of RTL_AUTOLAND: it lands by its mission only when a landing was given up. */
    private static final int ONLY_WHEN_IT_GOES_AROUND = 3;

    private static final int GO_ON_IN_AUTO = 2;
    private static final int GO_ON_WHEN_PILOTED = 16;

    private CloudLossParameterSets() {}

    static CloudLossParameters copter(int seconds, ReturnHeightExchanges.Setting height) {
        return new CloudLossParameters(
                List.of(
                        Setting.needed("FS_GCS_ENABLE", CloudLossParameters.instead(1, 0.0)),
                        Setting.ifThere(old -> seconds, "FS_GCS_TIMEOUT"),
                        Setting.ifThere(old -> (long) old | GO_ON_WHEN_PILOTED, "FS_OPTIONS")
                                .withBits(GO_ON_IN_AUTO | GO_ON_WHEN_PILOTED)),
                height,
                (now, owners) -> copter(now));
    }

    private static CloudLossAction copter(Map<String, Double> now) {
        int action = (int) CloudLossParameters.find(now, "FS_GCS_ENABLE").orElse(0);
        String words = switch (action) {
            case 0 -> GOES_ON;
            case 1, 2, 3, 6 -> HOME;
            case 4 -> "it returns the way it came, or lands";
            case 7 -> "it brakes, or lands";
            default -> DOWN;
        };
        return acting(words, now, "FS_GCS_TIMEOUT", action == 2 ? "On a mission it goes on." : "");
    }

    /**
     * It lands at home instead of circling there, where its mission lets it, or on rotors: a QuadPlane says that it is a fixed
     * wing unless its owner has set Q_MAV_TYPE.
     */
    static CloudLossParameters plane(int seconds) {
        return winged(
                seconds,
                (now, owners) -> plane(
                        now, owners, CloudLossParameters.find(now, Q_ENABLE).orElse(0) > 0),
                Setting.ifThere(CloudLossParameters.instead(1, 0.0), AUTOLAND),
                Setting.ifThere(old -> old, Q_ENABLE),
                Setting.ifThere(CloudLossParameters.instead(1, 0.0), Q_RTL_MODE));
    }

    /** It lands at home on its rotors. */
    static CloudLossParameters quadPlane(int seconds) {
        return winged(
                seconds,
                (now, owners) -> plane(now, owners, true),
                Setting.ifThere(CloudLossParameters.instead(1, 0.0), Q_RTL_MODE));
    }

    private static CloudLossParameters winged(int seconds, CloudLossParameters.Acting action, Setting... lands) {
        List<Setting> settings = new ArrayList<>(List.of(
                Setting.needed("FS_GCS_ENABL", CloudLossParameters.instead(1, 0.0, 3.0)),
                Setting.needed("FS_LONG_ACTN", CloudLossParameters.instead(1, 0.0)),
                Setting.ifThere(old -> Math.min(old, seconds), "FS_LONG_TIMOUT", "FS_LONG_TIMEOUT")));
        settings.addAll(List.of(lands));
        return new CloudLossParameters(settings, null, action);
    }

    private static CloudLossAction plane(Map<String, Double> now, Map<String, Double> owners, boolean rotors) {
        boolean listens = CloudLossParameters.find(now, "FS_GCS_ENABL").orElse(0) > 0;
        int action = (int) CloudLossParameters.find(now, "FS_LONG_ACTN").orElse(0);
        String words = switch (listens ? action : 0) {
            case 0 -> GOES_ON;
            case 1 -> HOME;
            case 2 -> "it glides down";
            case 3 -> "it opens its parachute";
            case 4 -> "it flies its mission";
            default -> DOWN;
        };
        String note = shared(now, owners, "FS_LONG_ACTN", "FS_LONG_TIMOUT");
        return words.equals(HOME) ? home(now, rotors, note) : acting(words, now, "FS_LONG_TIMOUT", note);
    }

    /** Its end at home. */
    private static CloudLossAction home(Map<String, Double> now, boolean hasRotors, String note) {
        boolean onRotors = CloudLossParameters.find(now, Q_RTL_MODE).orElse(0) > 0;
        int autoland = (int) CloudLossParameters.find(now, AUTOLAND).orElse(0);
        if (hasRotors) {
            String rotors = onRotors ? "" : OWNERS_ROTORS;
            return homeward(now, AtHome.BY_ITSELF, rotors, note);
        }
        return switch (autoland) {
            case 1, 2 -> homeward(now, AtHome.BY_MISSION, "", note);
            case 0, ONLY_WHEN_IT_GOES_AROUND -> homeward(now, AtHome.AS_SAID, CIRCLES, note);
            default -> homeward(now, AtHome.AS_SAID, OWNERS_LANDING, note);
        };
    }

    private static CloudLossAction homeward(Map<String, Double> now, AtHome atHome, String first, String note) {
        CloudLossAction action = acting(HOME, now, "FS_LONG_TIMOUT", (first + " " + note).strip());
        return new CloudLossAction(action.action(), action.afterSeconds(), action.note(), atHome);
    }

    static CloudLossParameters rover(int seconds) {
        return new CloudLossParameters(
                List.of(
                        Setting.needed("FS_GCS_ENABLE", CloudLossParameters.instead(1, 0.0)),
                        Setting.ifThere(old -> seconds, "FS_GCS_TIMEOUT"),
                        Setting.needed("FS_ACTION", CloudLossParameters.instead(1, 0.0))),
                null,
                CloudLossParameterSets::rover);
    }

    private static CloudLossAction rover(Map<String, Double> now, Map<String, Double> owners) {
        int listens = (int) CloudLossParameters.find(now, "FS_GCS_ENABLE").orElse(0);
        int action = (int) CloudLossParameters.find(now, "FS_ACTION").orElse(0);
        String words = switch (listens == 0 ? 0 : action) {
            case 0 -> GOES_ON;
            case 1, 3 -> HOME;
            case 2, 4 -> "it stops";
            default -> "it does what its owner has set";
        };
        String note = shared(now, owners, "FS_ACTION", "FS_ACTION");
        return acting(words, now, "FS_GCS_TIMEOUT", listens == 2 ? (note + " On a mission it goes on.").strip() : note);
    }

    /** Whether the cloud has made something stricter that holds without the remote control, too. */
    private static String shared(Map<String, Double> now, Map<String, Double> owners, String action, String time) {
        boolean changed = !CloudLossParameters.find(now, action).equals(CloudLossParameters.find(owners, action))
                || !CloudLossParameters.find(now, time).equals(CloudLossParameters.find(owners, time));
        return changed ? ALSO_RC : "";
    }

    private static CloudLossAction acting(String words, Map<String, Double> now, String time, String note) {
        if (words.equals(GOES_ON)) {
            return new CloudLossAction(words, null, note);
        }
        return CloudLossParameters.find(now, time).isPresent()
                ? new CloudLossAction(words, CloudLossParameters.find(now, time).getAsDouble(), note)
                : new CloudLossAction(words, FIXED_SECONDS, (FIXED + " " + note).strip());
    }

    static CloudLossParameters px4(int seconds, ReturnHeightExchanges.@Nullable Setting height) {
        return new CloudLossParameters(
                List.of(
                        Setting.needed("NAV_DLL_ACT", CloudLossParameters.instead(2, 0.0, 1.0)),
                        Setting.ifThere(old -> seconds, "COM_DL_LOSS_T"),
                        Setting.ifThere(old -> old, "COM_DLL_EXCEPT").withBits(1)),
                height,
                (now, owners) -> px4(now));
    }

    private static CloudLossAction px4(Map<String, Double> now) {
        int action = (int) CloudLossParameters.find(now, "NAV_DLL_ACT").orElse(0);
        String words = switch (action) {
            case 0 -> GOES_ON;
            case 1 -> "it stays where it is";
            case 2 -> HOME;
            case 3 -> DOWN;
            default -> "it stops its motors";
        };
        boolean timed = CloudLossParameters.find(now, "COM_DL_LOSS_T").isPresent();
        return action == 0
                ? new CloudLossAction(words, null, "")
                : new CloudLossAction(
                        words,
                        timed
                                ? (Double) CloudLossParameters.find(now, "COM_DL_LOSS_T")
                                        .getAsDouble()
                                : null,
                        timed ? "" : FIXED);
    }
}
