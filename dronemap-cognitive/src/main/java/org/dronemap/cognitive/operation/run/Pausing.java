package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.time.Instant;
import org.dronemap.cognitive.operation.run.RunDrone.Errand;
import org.dronemap.core.command.Command;

/** Pauses and resumes a run: drones in the air hold, drones on the ground stay, landings go on. */
final class Pausing {
    private Pausing() {}

    static void wish(Draft draft, RunInput.Wish wish) {
        if (wish instanceof RunInput.Pause) {
            pause(draft, wish.by());
        } else {
            goOn(draft, wish.by());
        }
    }

    /** What is being planned is for drones that fly on. */
    private static void pause(Draft draft, String by) {
        Request open = draft.request();
        if (open != null) {
            draft.causes().addAll(0, open.causes());
            draft.request(null);
        }
        draft.clock(draft.clock().paused(draft.now()));
        draft.say(
                Trigger.PAUSED, null, by + " paused the run: drones in the air hold, those on the ground stay there.");
    }

    /** Everybody waited for the same time: what was apart in time still is. */
    private static void goOn(Draft draft, String by) {
        Instant since = draft.clock().pausedSince();
        Duration paused = since == null ? Duration.ZERO : Duration.between(since, draft.now());
        for (RunDrone drone : draft.drones()) {
            Sortie sortie = drone.sortie();
            Sortie next = drone.next();
            RunDrone later = drone.flying(sortie == null ? null : later(sortie, paused), drone.passed())
                    .getting(next == null ? null : later(next, paused));
            boolean waits = drone.stage() == DroneStage.HOLDING && drone.errand() == null;
            draft.put(waits ? later.to(DroneStage.HOLDING, draft.now()) : later);
        }
        draft.clock(draft.clock().paused(null));
        draft.say(Trigger.WENT_ON, null, by + " let the run go on after " + paused.toSeconds() + " s.");
    }

    private static Sortie later(Sortie sortie, Duration paused) {
        return sortie.at(sortie.zero().plus(paused));
    }

    /** False: it does what it would do without the pause. */
    static boolean stays(Draft draft, RunDrone drone, Look look) {
        return switch (drone.stage()) {
            case READY -> true;
            case ARMING, STARTING -> staysDown(draft, drone, look);
            case FLYING -> stops(draft, drone, look);
            case HOLDING, REPLACING, CONTINUING -> holds(draft, drone, look);
            default -> false;
        };
    }

    private static boolean staysDown(Draft draft, RunDrone drone, Look look) {
        if (look.airborne() || look.isOnMission()) {
            return false;
        }
        if (look.isArmed()) {
            draft.give(drone, Errand.Kind.DISARM, new Command.Disarm(false));
        } else {
            draft.put(drone.to(DroneStage.READY, draft.now()));
        }
        return true;
    }

    /** Who climbs from the ground comes to its height first, and who has nothing left to visit lands. */
    private static boolean stops(Draft draft, RunDrone drone, Look look) {
        if (look.isOnMission() && !Crafts.isTakingOff(drone) && !drone.orders().isEmpty()) {
            Steps.pause(draft, drone.to(DroneStage.HOLDING, draft.now()));
        }
        return true;
    }

    private static boolean holds(Draft draft, RunDrone drone, Look look) {
        if (look.isOnMission()) {
            Steps.pause(draft, drone.to(DroneStage.HOLDING, draft.now()));
        } else if (drone.stage() != DroneStage.HOLDING) {
            draft.put(drone.to(DroneStage.HOLDING, draft.now()));
        }
        return true;
    }
}
