package org.dronemap.cognitive.operation.run;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.cognitive.operation.run.model.DroneObservation;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.core.command.MissionCloudLossPolicy;

/** Has a mission run wait for its drones' reports after a server restart, and accept that some return by fail-safe. */
final class RunCloudLoss {
    /** Noted of a drone that has not said all since the restart. */
    private static final RunTrigger UNCLEAR = RunTrigger.RESTARTED;
    /** Noted of a drone on its way home, or there, since it missed the cloud. */
    private static final RunTrigger MISSED = RunTrigger.HEARD_AGAIN;

    private RunCloudLoss() {}

    static void markUnclear(RunTransition draft) {
        draft.drones().stream()
                .filter(drone -> drone.stage().compareTo(RunDroneStage.RETURNING) <= 0)
                .forEach(drone -> draft.put(noting(drone, UNCLEAR)));
    }

    /** Whether it must be heard first. */
    static boolean isUnclear(RunDrone drone) {
        return drone.flags().triggers().contains(UNCLEAR);
    }

    /** True while nothing more can be said of it; who has told all since the restart is missed like any other. */
    static boolean isWaitedFor(RunTransition draft, DroneObservation look) {
        RunDrone drone = draft.drone(look.drone());
        if (!isUnclear(drone)) {
            return false;
        }
        Instant until = draft.clock().lossAfter();
        boolean late = until == null || !draft.now().isBefore(until);
        if (!look.isFullyReported() && !late) {
            return true;
        }
        draft.put(without(drone, UNCLEAR));
        // One that comes home over a bad link may be down before it has told what it carries.
        boolean seen = look.isLive() && look.mode() != null && look.armed() != null;
        if (seen && drone.stage().acceptsCommands() && drone.stage().mayFly()) {
            reported(draft, draft.drone(drone.id()), look);
        }
        return false;
    }

    /** What it has reached is reckoned already. */
    private static void reported(RunTransition draft, RunDrone drone, DroneObservation look) {
        boolean explained = bringsHome(draft, drone.stage() == RunDroneStage.FLYING);
        boolean done = drone.orders().isEmpty() && drone.next() == null;
        if (!explained || done || draft.stopping()) {
            return;
        }
        if (look.isDisarmed() && HomeArrival.isAtHome(drone, look)) {
            LostDrones.rejoin(draft, drone);
        } else if (look.comesDown()) {
            String words = drone.name() + " comes home or down by itself, as it missed the cloud.";
            DroneWithdrawal.withdraw(draft, drone, RunDroneStage.RETURNING, RunTrigger.HEARD_AGAIN, words);
            markMissed(draft, draft.drone(drone.id()));
        }
    }

    /** Whether a vehicle that misses the cloud comes home: one that waits for it always does. {@code flew}: its mission. */
    static boolean bringsHome(RunTransition draft, boolean flew) {
        return !flew || draft.setting().onCloudLoss() == MissionCloudLossPolicy.RETURN_TO_LAUNCH;
    }

    static void markMissed(RunTransition draft, RunDrone drone) {
        draft.put(noting(drone, MISSED));
    }

    static boolean hasMissed(RunDrone drone) {
        return drone.flags().triggers().contains(MISSED);
    }

    private static RunDrone noting(RunDrone drone, RunTrigger what) {
        List<RunTrigger> told = new ArrayList<>(drone.flags().triggers());
        told.add(what);
        return drone.with(drone.flags().triggers(told));
    }

    private static RunDrone without(RunDrone drone, RunTrigger what) {
        return drone.with(drone.flags()
                .triggers(drone.flags().triggers().stream()
                        .filter(each -> each != what)
                        .toList()));
    }
}
