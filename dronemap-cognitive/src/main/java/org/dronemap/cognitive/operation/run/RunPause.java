package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.time.Instant;
import org.dronemap.cognitive.operation.run.model.DroneObservation;
import org.dronemap.cognitive.operation.run.model.PendingReplan;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDrone.IssuedCommand;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.cognitive.operation.run.model.Sortie;
import org.dronemap.core.command.Command;

/** Pauses and resumes a mission run: drones in the air hold, drones on the ground stay, landings go on. */
final class RunPause {
    private RunPause() {}

    static void apply(RunTransition draft, RunInput.UserRequest wish) {
        if (wish instanceof RunInput.Pause) {
            pause(draft, wish.by());
        } else {
            goOn(draft, wish.by());
        }
    }

    /** What is being planned is for drones that fly on. */
    private static void pause(RunTransition draft, String by) {
        PendingReplan open = draft.request();
        if (open != null) {
            draft.causes().addAll(0, open.causes());
            draft.request(null);
        }
        draft.clock(draft.clock().paused(draft.now()));
        draft.explain(RunTrigger.PAUSED, null, by + " paused the run: " + whatTheyDo(draft));
    }

    /** Everybody waited for the same time: what was apart in time still is. */
    private static void goOn(RunTransition draft, String by) {
        Instant since = draft.clock().pausedSince();
        Duration paused = since == null ? Duration.ZERO : Duration.between(since, draft.now());
        for (RunDrone drone : draft.drones()) {
            Sortie sortie = drone.sortie();
            Sortie next = drone.next();
            RunDrone later = drone.withSortie(sortie == null ? null : later(sortie, paused), drone.passed())
                    .withNext(next == null ? null : later(next, paused));
            boolean waits = drone.stage() == RunDroneStage.HOLDING && drone.issuedCommand() == null;
            draft.put(waits ? later.to(RunDroneStage.HOLDING, draft.now()) : later);
        }
        draft.clock(draft.clock().paused(null));
        draft.explain(RunTrigger.WENT_ON, null, by + " let the run go on after " + paused.toSeconds() + " s.");
    }

    private static Sortie later(Sortie sortie, Duration paused) {
        return sortie.at(sortie.zero().plus(paused));
    }

    /** False: it does what it would do without the pause. */
    static boolean stays(RunTransition draft, RunDrone drone, DroneObservation look) {
        return switch (drone.stage()) {
            case READY -> true;
            case ARMING, STARTING -> staysDown(draft, drone, look);
            case FLYING -> stops(draft, drone, look);
            case HOLDING, REPLACING, CONTINUING -> holds(draft, drone, look);
            default -> false;
        };
    }

    private static boolean staysDown(RunTransition draft, RunDrone drone, DroneObservation look) {
        if (look.airborne() || look.isOnMission()) {
            return false;
        }
        if (look.isArmed()) {
            draft.sendCommand(drone, IssuedCommand.Purpose.DISARM, new Command.Disarm(false));
        } else {
            draft.put(drone.to(RunDroneStage.READY, draft.now()));
        }
        return true;
    }

    /** Who climbs from the ground comes to its height first, and who has nothing left to visit lands. */
    private static boolean stops(RunTransition draft, RunDrone drone, DroneObservation look) {
        if (look.isOnMission()
                && !CraftSnapshots.isTakingOff(drone)
                && !drone.orders().isEmpty()) {
            RunCommands.pause(draft, drone.to(RunDroneStage.HOLDING, draft.now()));
        }
        return true;
    }

    private static boolean holds(RunTransition draft, RunDrone drone, DroneObservation look) {
        if (look.isOnMission()) {
            RunCommands.pause(draft, drone.to(RunDroneStage.HOLDING, draft.now()));
        } else if (drone.stage() != RunDroneStage.HOLDING) {
            draft.put(drone.to(RunDroneStage.HOLDING, draft.now()));
        }
        return true;
    }

    /** What drives holds as well, and is not in the air. */
    private static String whatTheyDo(RunTransition draft) {
        boolean driven =
                draft.drones().stream().anyMatch(drone -> !drone.profile().flies());
        return driven && !draft.isWordedBefore(2)
                ? "drones under way hold, the others stay where they are."
                : "drones in the air hold, those on the ground stay there.";
    }
}
