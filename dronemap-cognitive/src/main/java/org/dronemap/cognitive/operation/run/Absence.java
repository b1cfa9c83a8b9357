package org.dronemap.cognitive.operation.run;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.command.CloudLoss;

/** Handles drones that flew without the cloud: waits for their reports, and accepts a fail-safe return. */
final class Absence {
    /** Noted of a drone that has not said all since the restart. */
    private static final Trigger UNCLEAR = Trigger.RESTARTED;
    /** Noted of a drone on its way home, or there, since it missed the cloud. */
    private static final Trigger MISSED = Trigger.HEARD_AGAIN;

    private Absence() {}

    static void begin(Draft draft) {
        draft.drones().stream()
                .filter(drone -> drone.stage().compareTo(DroneStage.RETURNING) <= 0)
                .forEach(drone -> draft.put(noting(drone, UNCLEAR)));
    }

    /** Whether it must be heard first. */
    static boolean isUnclear(RunDrone drone) {
        return drone.signs().told().contains(UNCLEAR);
    }

    /** True while nothing more can be said of it; who has told all since the restart is missed like any other. */
    static boolean isWaitedFor(Draft draft, Look look) {
        RunDrone drone = draft.drone(look.drone());
        if (!isUnclear(drone)) {
            return false;
        }
        Instant until = draft.clock().hearsAfter();
        boolean late = until == null || !draft.now().isBefore(until);
        if (!look.tells() && !late) {
            return true;
        }
        draft.put(without(drone, UNCLEAR));
        // One that comes home over a bad link may be down before it has told what it carries.
        boolean seen = look.isLive() && look.mode() != null && look.armed() != null;
        if (seen && drone.stage().takesOrders() && drone.stage().mayFly()) {
            back(draft, draft.drone(drone.id()), look);
        }
        return false;
    }

    /** What it has reached is reckoned already. */
    private static void back(Draft draft, RunDrone drone, Look look) {
        boolean explained = bringsHome(draft, drone.stage() == DroneStage.FLYING);
        boolean done = drone.orders().isEmpty() && drone.next() == null;
        if (!explained || done || draft.stopping()) {
            return;
        }
        if (look.isDisarmed() && Silences.isAtHome(drone, look)) {
            Silences.takesPartAgain(draft, drone);
        } else if (look.comesDown()) {
            String words = drone.name() + " comes home or down by itself, as it missed the cloud.";
            Faults.leave(draft, drone, DroneStage.RETURNING, Trigger.HEARD_AGAIN, words);
            missed(draft, draft.drone(drone.id()));
        }
    }

    /** Whether a vehicle that misses the cloud comes home: one that waits for it always does. {@code flew}: its mission. */
    static boolean bringsHome(Draft draft, boolean flew) {
        return !flew || draft.setting().onCloudLoss() == CloudLoss.RETURN_TO_LAUNCH;
    }

    static void missed(Draft draft, RunDrone drone) {
        draft.put(noting(drone, MISSED));
    }

    static boolean hasMissed(RunDrone drone) {
        return drone.signs().told().contains(MISSED);
    }

    private static RunDrone noting(RunDrone drone, Trigger what) {
        List<Trigger> told = new ArrayList<>(drone.signs().told());
        told.add(what);
        return drone.with(drone.signs().told(told));
    }

    private static RunDrone without(RunDrone drone, Trigger what) {
        return drone.with(drone.signs()
                .told(drone.signs().told().stream().filter(each -> each != what).toList()));
    }
}
