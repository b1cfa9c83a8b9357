package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.dronemap.cognitive.operation.run.model.DroneObservation;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDrone.IssuedCommand;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.cognitive.operation.run.model.Sortie;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.core.command.Command;

/**
 * Chooses the next command for one drone of a mission run by its stage and the waypoints it is to visit. What is
 * already so is never commanded.
 */
final class RunCommands {
    /** Before it is called home once more. */
    private static final Duration BETWEEN_CALLS = Duration.ofSeconds(5);

    private static final Duration LONGEST_STILL_ON_ITS_WAY_HOME = Duration.ofSeconds(90);
    /** In the air without a plan. */
    private static final Duration LONGEST_HOLD = Duration.ofSeconds(60);

    private RunCommands() {}

    static void advance(RunTransition draft, DroneObservation look) {
        RunDrone drone = draft.drone(look.drone());
        boolean controlled = look.holder() == null && look.isLive() && look.ready();
        if (!controlled || drone.issuedCommand() != null || RunCloudLoss.isUnclear(drone)) {
            return;
        }
        if (waits(draft, drone)) {
            return;
        }
        if (draft.isPaused() && RunPause.stays(draft, drone, look)) {
            return;
        }
        switch (drone.stage()) {
            case LANDED, READY, UPLOADING, ARMING, STARTING -> onTheGround(draft, drone, look);
            case FLYING -> fly(draft, drone, look);
            case HOLDING -> hold(draft, drone, look);
            case REPLACING -> replace(draft, drone, look);
            case CONTINUING -> goOn(draft, drone, look);
            case RESUMING -> resume(draft, drone, look);
            case RETURNING -> commandReturn(draft, drone, look);
            default -> {}
        }
    }

    private static boolean waits(RunTransition draft, RunDrone drone) {
        Instant notBefore = drone.attempts().notBefore();
        return notBefore != null && draft.now().isBefore(notBefore);
    }

    private static void onTheGround(RunTransition draft, RunDrone drone, DroneObservation look) {
        switch (drone.stage()) {
            case LANDED, READY -> ready(draft, drone, look);
            case UPLOADING -> upload(draft, drone, look);
            case ARMING -> arm(draft, drone, look);
            default -> start(draft, drone, look);
        }
    }

    private static void ready(RunTransition draft, RunDrone drone, DroneObservation look) {
        Sortie sortie = drone.sortie();
        boolean done = drone.stage() == RunDroneStage.LANDED && drone.next() == null && look.isDisarmed();
        if (done && ReturnHeightOverride.restore(draft, drone)) {
            return;
        } else if (drone.next() != null) {
            draft.put(drone.to(RunDroneStage.UPLOADING, draft.now()));
        } else if (drone.stage() == RunDroneStage.READY && sortie != null && mayRise(draft, drone, sortie)) {
            draft.put(drone.to(RunDroneStage.ARMING, draft.now()));
        }
    }

    private static boolean mayRise(RunTransition draft, RunDrone drone, Sortie sortie) {
        return LaunchTiming.isDue(draft, sortie) && drone.flags().waitsFor() == null;
    }

    private static void upload(RunTransition draft, RunDrone drone, DroneObservation look) {
        Sortie next = drone.next();
        if (next == null) {
            draft.put(drone.to(drone.sortie() == null ? RunDroneStage.LANDED : RunDroneStage.READY, draft.now()));
        } else if (TaskReports.skipDone(draft, drone, next) || UnflyableWaypoints.foundBefore(draft, drone, look)) {
            return;
        } else if (Boolean.TRUE.equals(look.progress().carriesNext())) {
            draft.put(uploaded(drone, next).to(RunDroneStage.READY, draft.now()));
        } else if (WaypointTransfer.isFree(draft, drone, next)) {
            uploadWhenIdle(draft, drone, next, look);
        }
    }

    /** It waits for the end of a transfer that goes on: the gate would refuse it, which says nothing against the drone. */
    private static void uploadWhenIdle(RunTransition draft, RunDrone drone, Sortie next, DroneObservation look) {
        if (look.transfer() == null) {
            draft.sendCommand(drone, IssuedCommand.Purpose.UPLOAD, new Command.UploadMission(next.mission()));
        }
    }

    static RunDrone uploaded(RunDrone drone, Sortie next) {
        return drone.withSortie(next, 0)
                .withNext(null)
                .with(drone.flags().triggers(List.of()).begun(false));
    }

    private static void arm(RunTransition draft, RunDrone drone, DroneObservation look) {
        if (drone.next() != null) {
            draft.put(drone.to(RunDroneStage.UPLOADING, draft.now()));
        } else if (look.isArmed()) {
            // One that disarms itself again and again is not armed for ever.
            draft.put(drone.to(RunDroneStage.STARTING, draft.now()).tried(drone.attempts()));
        } else if (drone.flags().waitsFor() != null || ReturnHeightOverride.set(draft, drone)) {
            return;
        } else if (look.ordersMode() != null) {
            draft.sendCommand(drone, IssuedCommand.Purpose.MODE, new Command.SetMode(look.ordersMode()));
        } else {
            draft.sendCommand(drone, IssuedCommand.Purpose.ARM, new Command.Arm());
        }
    }

    private static void start(RunTransition draft, RunDrone drone, DroneObservation look) {
        if (look.isOnMission() && isUp(drone, look)) {
            draft.put(drone.to(RunDroneStage.FLYING, draft.now()));
        } else if (look.isArmed()) {
            draft.sendCommand(drone, IssuedCommand.Purpose.START, begin(draft, true));
        } else if (look.isDisarmed()) {
            RunCommandResults.failed(draft, drone, "it was disarmed before it started");
            armAgain(draft, draft.drone(drone.id()));
        }
    }

    /** Where it is when it is under way: in the air, unless it drives. */
    private static boolean isUp(RunDrone drone, DroneObservation look) {
        return look.airborne() || !drone.profile().flies();
    }

    private static void armAgain(RunTransition draft, RunDrone drone) {
        if (drone.stage() == RunDroneStage.STARTING) {
            draft.put(drone.to(RunDroneStage.ARMING, draft.now()).tried(drone.attempts()));
        }
    }

    private static Command begin(RunTransition draft, boolean anew) {
        return new Command.StartMission(draft.setting().onCloudLoss(), anew);
    }

    private static void fly(RunTransition draft, RunDrone drone, DroneObservation look) {
        Sortie next = drone.next();
        if (HomeArrival.isDriven(drone, look)) {
            HomeArrival.end(draft, drone);
            return;
        }
        if (next == null
                || !look.isOnMission()
                || CraftSnapshots.isTakingOff(drone)
                || WaypointProximity.isBefore(draft, drone, next, look)) {
            return;
        }
        if (WaypointTransfer.gives(drone, next) || WaypointTransfer.isFree(draft, drone, next)) {
            pause(draft, drone.to(RunDroneStage.HOLDING, draft.now()));
        }
    }

    static void pause(RunTransition draft, RunDrone drone) {
        draft.sendCommand(drone, IssuedCommand.Purpose.HOLD, new Command.PauseMission());
    }

    private static void hold(RunTransition draft, RunDrone drone, DroneObservation look) {
        Sortie next = drone.next();
        if (look.isOnMission()) {
            pause(draft, drone);
        } else if (!look.waits()) {
            return;
        } else if (next != null) {
            if (WaypointTransfer.isFree(draft, drone, next)) {
                draft.put(drone.to(RunDroneStage.REPLACING, draft.now()));
            }
        } else if (drone.flags().waitsFor() == null) {
            awaitPlan(draft, drone);
        }
    }

    private static void resume(RunTransition draft, RunDrone drone, DroneObservation look) {
        if (look.isDisarmed()) {
            draft.put(drone.withSortie(null, 0).to(RunDroneStage.LANDED, draft.now()));
        } else if (look.waits() && isUp(drone, look)) {
            draft.put(drone.to(RunDroneStage.HOLDING, draft.now()));
        } else if (!isUp(drone, look)) {
            draft.sendCommand(drone, IssuedCommand.Purpose.DISARM, new Command.Disarm(false));
            return;
        } else {
            pause(draft, drone);
            return;
        }
        draft.addCause(RunTrigger.RESUMED, drone.id(), drone.name() + " takes part again.");
    }

    /** It waits for a plan, and goes on where its mission leads to its own waypoints alone. */
    private static void awaitPlan(RunTransition draft, RunDrone drone) {
        Sortie sortie = drone.sortie();
        boolean planned = draft.request() == null && draft.causes().isEmpty() && draft.proposal() == null;
        if (planned && sortie != null && drone.orders().containsAll(sortie.ahead(drone.passed()))) {
            draft.put(drone.to(RunDroneStage.CONTINUING, draft.now()));
        } else if (Duration.between(drone.since(), draft.now()).compareTo(LONGEST_HOLD) > 0) {
            DroneWithdrawal.callHome(
                    draft, drone, RunTrigger.LATE, "There is no plan for " + drone.name() + "; it is called home.");
        }
    }

    private static void replace(RunTransition draft, RunDrone drone, DroneObservation look) {
        Sortie next = drone.next();
        if (look.isOnMission()) {
            pause(draft, drone.to(RunDroneStage.HOLDING, draft.now()));
        } else if (next == null) {
            draft.put(drone.to(RunDroneStage.HOLDING, draft.now()));
        } else if (isAmended(draft, drone, next, look)) {
            return;
        } else if (Boolean.TRUE.equals(look.progress().carriesNext())) {
            draft.put(uploaded(drone, next).to(RunDroneStage.CONTINUING, draft.now()));
        } else if (!WaypointTransfer.isFree(draft, drone, next)) {
            // A newer plan came while it was about to get the one before.
            draft.put(drone.to(RunDroneStage.HOLDING, draft.now()));
        } else {
            uploadWhenIdle(draft, drone, next, look);
        }
    }

    /** Or may have to be: what it did of its last mission is not done again. */
    private static boolean isAmended(RunTransition draft, RunDrone drone, Sortie next, DroneObservation look) {
        return UnflyableWaypoints.foundBefore(draft, drone, look)
                || TaskReports.skipDone(draft, drone, next)
                || TaskReports.mayReportYet(draft, drone, look)
                || leavesOutWhatIsDone(draft, drone, next, look);
    }

    private static boolean leavesOutWhatIsDone(
            RunTransition draft, RunDrone drone, Sortie next, DroneObservation look) {
        Place place = look.place();
        Optional<Sortie> left = place == null ? Optional.empty() : TourAssigner.remaining(draft, drone, next, place);
        left.ifPresent(sortie -> draft.put(drone.withNext(sortie)));
        return left.isPresent();
    }

    private static void goOn(RunTransition draft, RunDrone drone, DroneObservation look) {
        if (look.isOnMission()) {
            draft.put(drone.to(RunDroneStage.FLYING, draft.now()));
        } else if (drone.next() != null) {
            draft.put(drone.to(RunDroneStage.HOLDING, draft.now()));
        } else {
            draft.sendCommand(drone, IssuedCommand.Purpose.START, begin(draft, drone.passed() == 0));
        }
    }

    /** How long it stood before it was called does not count. */
    private static boolean isStuck(RunTransition draft, RunDrone drone, DroneObservation look) {
        Duration called = Duration.between(drone.since(), draft.now());
        return look.still().compareTo(LONGEST_STILL_ON_ITS_WAY_HOME) > 0
                && called.compareTo(LONGEST_STILL_ON_ITS_WAY_HOME) > 0;
    }

    private static void downAtHome(RunTransition draft, RunDrone drone, DroneObservation look) {
        if (!draft.stopping() && LostDrones.cameHome(drone, look)) {
            LostDrones.rejoin(draft, drone);
        } else if (!ReturnHeightOverride.restore(draft, drone)) {
            draft.put(drone.to(draft.stopping() ? RunDroneStage.LANDED : RunDroneStage.LEFT, draft.now()));
        }
    }

    private static void commandReturn(RunTransition draft, RunDrone drone, DroneObservation look) {
        if (look.isDisarmed()) {
            downAtHome(draft, drone, look);
        } else if (HomeArrival.standsAtHome(drone, look)) {
            HomeArrival.end(draft, drone);
        } else if (isStuck(draft, drone, look)) {
            draft.explain(RunTrigger.LATE, drone.id(), drone.name() + " is stuck on its way home.");
            draft.put(drone.noted("It is stuck on its way home.").to(RunDroneStage.LEFT, draft.now()));
        } else if (!look.comesDown() && drone.flags().waitsFor() == null) {
            Command home = look.canReturn() ? new Command.ReturnToLaunch() : new Command.Land();
            boolean up = isUp(drone, look);
            draft.sendCommand(
                    drone.tried(new RunDrone.Attempts(0, draft.now().plus(BETWEEN_CALLS))),
                    up ? IssuedCommand.Purpose.HOME : IssuedCommand.Purpose.DISARM,
                    up ? home : new Command.Disarm(false));
        }
    }
}
