package org.dronemap.proxy.mavlink.translate;

import java.util.List;
import java.util.Map;
import org.dronemap.core.drone.LossAction;
import org.dronemap.proxy.mavlink.translate.LossPolicy.Setting;
import org.jspecify.annotations.Nullable;

/**
 * How each kind of vehicle is set. Only what concerns nothing but the ground station gets its time; what a vehicle does without its
 * remote control as well is made stricter, never laxer.
 */
final class LossPolicies {
    private static final String HOME = "it returns home";
    private static final String DOWN = "it lands";
    private static final String GOES_ON = "it goes on";
    /** Firmware that cannot be told when waits so long. */
    private static final double FIXED_SECONDS = 5;

    private static final String FIXED = "Its time cannot be set.";
    private static final String ALSO_RC = "It does the same when it loses its remote control.";
    private static final String CIRCLES =
            "It lands there only by a landing sequence of its mission (DO_LAND_START), else it circles.";
    private static final int GO_ON_IN_AUTO = 2;
    private static final int GO_ON_WHEN_PILOTED = 16;

    private LossPolicies() {}

    static LossPolicy copter(int seconds, ReturnHeights.Setting height) {
        return new LossPolicy(
                List.of(
                        Setting.needed("FS_GCS_ENABLE", LossPolicy.instead(1, 0.0)),
                        Setting.ifThere(old -> seconds, "FS_GCS_TIMEOUT"),
                        Setting.ifThere(old -> (long) old | GO_ON_WHEN_PILOTED, "FS_OPTIONS")
                                .withBits(GO_ON_IN_AUTO | GO_ON_WHEN_PILOTED)),
                height,
                (now, owners) -> copter(now));
    }

    private static LossAction copter(Map<String, Double> now) {
        int action = (int) LossPolicy.find(now, "FS_GCS_ENABLE").orElse(0);
        String words = switch (action) {
            case 0 -> GOES_ON;
            case 1, 2, 3, 6 -> HOME;
            case 4 -> "it returns the way it came, or lands";
            case 7 -> "it brakes, or lands";
            default -> DOWN;
        };
        return acting(words, now, "FS_GCS_TIMEOUT", action == 2 ? "On a mission it goes on." : "");
    }

    /** {@code lands}: by what it lands at home instead of circling there, where its mission or its rotors let it. */
    static LossPolicy plane(int seconds, String lands) {
        return new LossPolicy(
                List.of(
                        Setting.needed("FS_GCS_ENABL", LossPolicy.instead(1, 0.0, 3.0)),
                        Setting.needed("FS_LONG_ACTN", LossPolicy.instead(1, 0.0)),
                        Setting.ifThere(LossPolicy.instead(1, 0.0), lands),
                        Setting.ifThere(old -> Math.min(old, seconds), "FS_LONG_TIMOUT", "FS_LONG_TIMEOUT")),
                null,
                LossPolicies::plane);
    }

    private static LossAction plane(Map<String, Double> now, Map<String, Double> owners) {
        boolean listens = LossPolicy.find(now, "FS_GCS_ENABL").orElse(0) > 0;
        int action = (int) LossPolicy.find(now, "FS_LONG_ACTN").orElse(0);
        String words = switch (listens ? action : 0) {
            case 0 -> GOES_ON;
            case 1 -> HOME;
            case 2 -> "it glides down";
            case 3 -> "it opens its parachute";
            case 4 -> "it flies its mission";
            default -> DOWN;
        };
        String note = shared(now, owners, "FS_LONG_ACTN", "FS_LONG_TIMOUT");
        boolean circles =
                words.equals(HOME) && LossPolicy.find(now, "Q_RTL_MODE").isEmpty();
        return acting(words, now, "FS_LONG_TIMOUT", circles ? (CIRCLES + " " + note).strip() : note);
    }

    static LossPolicy rover(int seconds) {
        return new LossPolicy(
                List.of(
                        Setting.needed("FS_GCS_ENABLE", LossPolicy.instead(1, 0.0)),
                        Setting.ifThere(old -> seconds, "FS_GCS_TIMEOUT"),
                        Setting.needed("FS_ACTION", LossPolicy.instead(1, 0.0))),
                null,
                LossPolicies::rover);
    }

    private static LossAction rover(Map<String, Double> now, Map<String, Double> owners) {
        int listens = (int) LossPolicy.find(now, "FS_GCS_ENABLE").orElse(0);
        int action = (int) LossPolicy.find(now, "FS_ACTION").orElse(0);
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
        boolean changed = !LossPolicy.find(now, action).equals(LossPolicy.find(owners, action))
                || !LossPolicy.find(now, time).equals(LossPolicy.find(owners, time));
        return changed ? ALSO_RC : "";
    }

    private static LossAction acting(String words, Map<String, Double> now, String time, String note) {
        if (words.equals(GOES_ON)) {
            return new LossAction(words, null, note);
        }
        return LossPolicy.find(now, time).isPresent()
                ? new LossAction(words, LossPolicy.find(now, time).getAsDouble(), note)
                : new LossAction(words, FIXED_SECONDS, (FIXED + " " + note).strip());
    }

    static LossPolicy px4(int seconds, ReturnHeights.@Nullable Setting height) {
        return new LossPolicy(
                List.of(
                        Setting.needed("NAV_DLL_ACT", LossPolicy.instead(2, 0.0, 1.0)),
                        Setting.ifThere(old -> seconds, "COM_DL_LOSS_T"),
                        Setting.ifThere(old -> old, "COM_DLL_EXCEPT").withBits(1)),
                height,
                (now, owners) -> px4(now));
    }

    private static LossAction px4(Map<String, Double> now) {
        int action = (int) LossPolicy.find(now, "NAV_DLL_ACT").orElse(0);
        String words = switch (action) {
            case 0 -> GOES_ON;
            case 1 -> "it stays where it is";
            case 2 -> HOME;
            case 3 -> DOWN;
            default -> "it stops its motors";
        };
        boolean timed = LossPolicy.find(now, "COM_DL_LOSS_T").isPresent();
        return action == 0
                ? new LossAction(words, null, "")
                : new LossAction(
                        words,
                        timed ? (Double) LossPolicy.find(now, "COM_DL_LOSS_T").getAsDouble() : null,
                        timed ? "" : FIXED);
    }
}
