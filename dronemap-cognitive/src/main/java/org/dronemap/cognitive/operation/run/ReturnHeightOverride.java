package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.util.Locale;
import org.dronemap.cognitive.operation.run.model.DroneObservation;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDrone.IssuedCommand;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.core.command.SetReturnHeight;
import org.dronemap.core.drone.ReturnHeight;
import org.jspecify.annotations.Nullable;

/** Sets a drone's return height for a mission run, and restores the owner's value afterwards. */
final class ReturnHeightOverride {
    private static final double SAME_METERS = 0.5;
    private static final int MOST_TRIES = 3;
    private static final Duration BETWEEN_TRIES = Duration.ofSeconds(1);

    private ReturnHeightOverride() {}

    /** What was set before shows once it was told its layer. */
    static void recordPrevious(RunTransition draft, RunDrone drone, DroneObservation look) {
        ReturnHeight set = look.returnHeight();
        ReturnHeight asked = drone.flags().returnHeight();
        if (set == null || asked == null || drone.stage() != RunDroneStage.ARMING) {
            return;
        }
        if (asked.meters() == asked.beforeMeters() && set.meters() > asked.meters() - SAME_METERS) {
            draft.put(drone.with(drone.flags().returnHeight(set)));
        }
    }

    /** False: nothing is to be set. */
    static boolean set(RunTransition draft, RunDrone drone) {
        Double layer = drone.profile().returnMeters();
        if (layer == null || drone.flags().returnHeight() != null) {
            return false;
        }
        draft.sendCommand(drone, IssuedCommand.Purpose.HEIGHT, new SetReturnHeight(layer, true));
        return true;
    }

    /** On the ground, when it has nothing to fly. True: that takes a moment. */
    static boolean restore(RunTransition draft, RunDrone drone) {
        ReturnHeight set = drone.flags().returnHeight();
        if (set == null) {
            return false;
        }
        if (Math.abs(set.meters() - set.beforeMeters()) < SAME_METERS) {
            draft.put(drone.with(drone.flags().returnHeight(null)));
            return false;
        }
        draft.sendCommand(drone, IssuedCommand.Purpose.HEIGHT, new SetReturnHeight(set.beforeMeters(), false));
        return true;
    }

    static void succeeded(RunTransition draft, RunDrone drone) {
        Double layer = drone.profile().returnMeters();
        ReturnHeight told =
                layer == null || drone.flags().returnHeight() != null ? null : new ReturnHeight(layer, layer);
        draft.put(drone.with(drone.flags().returnHeight(told)));
    }

    /** It flies all the same: others look out for it then. */
    static void failed(RunTransition draft, RunDrone drone, String why) {
        int failed = drone.attempts().failed() + 1;
        if (failed < MOST_TRIES) {
            draft.put(drone.tried(new RunDrone.Attempts(failed, draft.now().plus(BETWEEN_TRIES))));
            return;
        }
        ReturnHeight set = drone.flags().returnHeight();
        draft.put(
                set == null
                        ? drone.with(drone.profile().withoutLayer())
                        : drone.with(drone.flags().returnHeight(null)));
        draft.explain(
                RunTrigger.COMMAND_FAILED,
                drone.id(),
                set == null
                        ? drone.name() + " could not be told how high to fly home: " + why + "; it flies as it is set."
                        : leftoverNotice(drone, set) + " That could not be put back: " + why + ".");
    }

    /** What is left behind at the end, as a sentence; null: nothing. */
    static @Nullable String leftoverNotice(RunDrone drone) {
        ReturnHeight set = drone.flags().returnHeight();
        return set == null || Math.abs(set.meters() - set.beforeMeters()) < SAME_METERS
                ? null
                : leftoverNotice(drone, set);
    }

    private static String leftoverNotice(RunDrone drone, ReturnHeight set) {
        return String.format(
                Locale.ROOT,
                "%s still flies home at %.0f m; %.0f m was set before.",
                drone.name(),
                set.meters(),
                set.beforeMeters());
    }
}
