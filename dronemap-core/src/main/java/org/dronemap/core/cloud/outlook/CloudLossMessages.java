package org.dronemap.core.cloud.outlook;

import java.util.List;
import java.util.Optional;
import org.dronemap.core.command.ParameterOverrideRecorder;
import org.dronemap.core.drone.CloudLossAction;
import org.dronemap.core.drone.CloudLossState;
import org.dronemap.core.drone.ParameterOverrides;
import org.dronemap.core.safety.ReturnEnding;
import org.jspecify.annotations.Nullable;

/** Texts for users about what a drone does by itself when it loses the cloud. */
public final class CloudLossMessages {
    public static final String CANNOT_BE_SET = "What this vehicle does without the cloud cannot be set.";
    private static final String CROSSING =
            "No height is free to fly home at: its way home may cross that of another drone.";
    private static final String CIRCLES =
            "it flies home and circles there until its pilot or a mission lands it, or its battery is empty.";

    private CloudLossMessages() {}

    public static CloudLossState set(ParameterOverrideRecorder.OverridePlan plan, boolean crossing) {
        return new CloudLossState(
                CloudLossState.State.SET,
                plan.after(),
                plan.returnMeters(),
                plan.after().sentence() + (crossing ? " " + CROSSING : ""),
                List.of());
    }

    /** Only what is not as everybody expects it. */
    public static Optional<String> notable(ParameterOverrideRecorder.OverridePlan plan, boolean crossing) {
        return crossing || !plan.after().note().isEmpty()
                ? Optional.of(plan.after().sentence() + (crossing ? " " + CROSSING : ""))
                : Optional.empty();
    }

    public static CloudLossState notSet(ParameterOverrideRecorder.@Nullable OverridePlan plan, @Nullable String why) {
        String then = plan == null
                ? "It then does what its owner has set, and that is not known."
                : "As its owner had set it: " + plan.before().sentence();
        return new CloudLossState(
                CloudLossState.State.NOT_SET,
                plan == null ? null : plan.before(),
                null,
                "What it does without the cloud could not be set" + (why == null ? ". " : " (" + without(why) + "). ")
                        + then,
                List.of());
    }

    /** By an earlier run of the server, which knew what it does. */
    public static CloudLossState setBefore(ParameterOverrides kept) {
        return new CloudLossState(
                CloudLossState.State.SET,
                null,
                kept.returnMeters(),
                "What it does without the cloud was set before this server was started; it is put back when nobody uses it.",
                List.of());
    }

    public static CloudLossState cannotBeSet(String why) {
        return new CloudLossState(CloudLossState.State.CANNOT_BE_SET, null, null, why, List.of());
    }

    /** Its end at home; empty: it lands, as everybody expects. */
    public static Optional<String> atHome(ReturnEnding end, @Nullable CloudLossAction action) {
        return switch (end) {
            case LANDS -> Optional.empty();
            case LANDS_BY_MISSION ->
                Optional.of(
                        action != null && action.atHome() == CloudLossAction.AtHome.BY_MISSION
                                ? "Its mission has a landing sequence (DO_LAND_START): at home it lands by that."
                                : "Its mission has a landing sequence (DO_LAND_START): a return that is commanded from"
                                        + " here lands by that.");
            case CIRCLES -> Optional.of("It has no landing sequence (DO_LAND_START) in a mission on board: " + CIRCLES);
            case NOT_KNOWN ->
                Optional.of("Its mission is not known, so it is not known whether it has a landing sequence"
                        + " (DO_LAND_START): without one " + CIRCLES);
        };
    }

    public static String notPutBack(@Nullable String why) {
        return "What its owner had set could not be put back yet" + (why == null ? "" : " (" + without(why) + ")")
                + "; it is tried again each minute while it stands disarmed.";
    }

    /** The sentence goes on. */
    private static String without(String sentence) {
        return sentence.endsWith(".") ? sentence.substring(0, sentence.length() - 1) : sentence;
    }
}
