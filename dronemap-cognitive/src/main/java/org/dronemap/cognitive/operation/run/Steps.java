package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.dronemap.cognitive.operation.run.RunDrone.Errand;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.core.command.Command;

/**
 * Chooses the next command of one drone by its stage and orders; commands nothing that is so already. What is already
 * so is never commanded.
 */
final class Steps {
    /** Before it is called home once more. */
    private static final Duration BETWEEN_CALLS = Duration.ofSeconds(5);

    private static final Duration LONGEST_STILL_ON_ITS_WAY_HOME = Duration.ofSeconds(90);
    /** In the air without a plan. */
    private static final Duration LONGEST_HOLD = Duration.ofSeconds(60);

    private Steps() {}

    static void go(Draft draft, Look look) {
        RunDrone drone = draft.drone(look.drone());
        boolean controlled = look.takenBy() == null && look.isLive() && look.ready();
        if (!controlled || drone.errand() != null || Absence.isUnclear(drone)) {
            return;
        }
        if (waits(draft, drone)) {
            stepAside(draft, drone, look);
            return;
        }
        if (draft.isPaused() && Pausing.stays(draft, drone, look)) {
            return;
        }
        switch (drone.stage()) {
            case LANDED, READY, UPLOADING, ARMING, STARTING -> onTheGround(draft, drone, look);
            case FLYING -> fly(draft, drone, look);
            case HOLDING -> hold(draft, drone, look);
            case REPLACING -> replace(draft, drone, look);
            case CONTINUING -> goOn(draft, drone, look);
            case RESUMING -> resume(draft, drone, look);
            case RETURNING -> comeHome(draft, drone, look);
            default -> {}
        }
    }

    private static boolean waits(Draft draft, RunDrone drone) {
        Instant notBefore = drone.tries().notBefore();
        return notBefore != null && draft.now().isBefore(notBefore);
    }

    /** It flies no mission meanwhile: what it gets is brought to it on its step aside, and begun after that. */
    private static void stepAside(Draft draft, RunDrone drone, Look look) {
        Sortie next = drone.next();
        boolean steps = drone.stage() == DroneStage.HOLDING
                && drone.signs().yields() != null
                && drone.tries().failed() == 0
                && look.waits()
                && !draft.isPaused();
        if (!steps || next == null || !Transfer.isFree(draft, drone, next) || isAmended(draft, drone, next, look)) {
            return;
        }
        if (Boolean.TRUE.equals(look.progress().carriesNext())) {
            draft.put(onBoard(drone, next));
        } else {
            bring(draft, drone, next, look);
        }
    }

    private static void onTheGround(Draft draft, RunDrone drone, Look look) {
        switch (drone.stage()) {
            case LANDED, READY -> ready(draft, drone, look);
            case UPLOADING -> upload(draft, drone, look);
            case ARMING -> arm(draft, drone, look);
            default -> start(draft, drone, look);
        }
    }

    private static void ready(Draft draft, RunDrone drone, Look look) {
        Sortie sortie = drone.sortie();
        boolean done = drone.stage() == DroneStage.LANDED && drone.next() == null && look.isDisarmed();
        if (done && Homeward.putBack(draft, drone)) {
            return;
        } else if (drone.next() != null) {
            draft.put(drone.to(DroneStage.UPLOADING, draft.now()));
        } else if (drone.stage() == DroneStage.READY && sortie != null && mayRise(draft, drone, sortie)) {
            draft.put(drone.to(DroneStage.ARMING, draft.now()));
        }
    }

    private static boolean mayRise(Draft draft, RunDrone drone, Sortie sortie) {
        return Launch.isDue(draft, sortie) && drone.signs().yields() == null;
    }

    private static void upload(Draft draft, RunDrone drone, Look look) {
        Sortie next = drone.next();
        if (next == null) {
            draft.put(drone.to(drone.sortie() == null ? DroneStage.LANDED : DroneStage.READY, draft.now()));
        } else if (TaskReports.spare(draft, drone, next)) {
            return;
        } else if (Boolean.TRUE.equals(look.progress().carriesNext())) {
            draft.put(onBoard(drone, next).to(DroneStage.READY, draft.now()));
        } else if (Transfer.isFree(draft, drone, next)) {
            bring(draft, drone, next, look);
        }
    }

    /** It waits for the end of a transfer that goes on: the gate would refuse it, which says nothing against the drone. */
    private static void bring(Draft draft, RunDrone drone, Sortie next, Look look) {
        if (look.transfer() == null) {
            draft.give(drone, Errand.Kind.UPLOAD, new Command.UploadMission(next.mission()));
        }
    }

    static RunDrone onBoard(RunDrone drone, Sortie next) {
        return drone.flying(next, 0)
                .getting(null)
                .with(drone.signs().told(List.of()).begun(false));
    }

    private static void arm(Draft draft, RunDrone drone, Look look) {
        if (drone.next() != null) {
            draft.put(drone.to(DroneStage.UPLOADING, draft.now()));
        } else if (look.isArmed()) {
            // One that disarms itself again and again is not armed for ever.
            draft.put(drone.to(DroneStage.STARTING, draft.now()).tried(drone.tries()));
        } else if (drone.signs().yields() != null || Homeward.set(draft, drone)) {
            return;
        } else if (look.ordersMode() != null) {
            draft.give(drone, Errand.Kind.MODE, new Command.SetMode(look.ordersMode()));
        } else {
            draft.give(drone, Errand.Kind.ARM, new Command.Arm());
        }
    }

    private static void start(Draft draft, RunDrone drone, Look look) {
        if (look.isOnMission() && look.airborne()) {
            draft.put(drone.to(DroneStage.FLYING, draft.now()));
        } else if (look.isArmed()) {
            draft.give(drone, Errand.Kind.START, begin(draft, true));
        } else if (look.isDisarmed()) {
            Errands.failed(draft, drone, "it was disarmed before it started");
            armAgain(draft, draft.drone(drone.id()));
        }
    }

    private static void armAgain(Draft draft, RunDrone drone) {
        if (drone.stage() == DroneStage.STARTING) {
            draft.put(drone.to(DroneStage.ARMING, draft.now()).tried(drone.tries()));
        }
    }

    private static Command begin(Draft draft, boolean anew) {
        return new Command.StartMission(draft.setting().onCloudLoss(), anew);
    }

    private static void fly(Draft draft, RunDrone drone, Look look) {
        Sortie next = drone.next();
        if (next == null
                || !look.isOnMission()
                || Crafts.isTakingOff(drone)
                || Arrival.isBefore(draft, drone, next, look)) {
            return;
        }
        if (Transfer.gives(drone, next) || Transfer.isFree(draft, drone, next)) {
            pause(draft, drone.to(DroneStage.HOLDING, draft.now()));
        }
    }

    static void pause(Draft draft, RunDrone drone) {
        draft.give(drone, Errand.Kind.HOLD, new Command.PauseMission());
    }

    private static void hold(Draft draft, RunDrone drone, Look look) {
        Sortie next = drone.next();
        if (look.isOnMission()) {
            pause(draft, drone);
        } else if (!look.waits()) {
            return;
        } else if (next != null) {
            if (Transfer.isFree(draft, drone, next)) {
                draft.put(drone.to(DroneStage.REPLACING, draft.now()));
            }
        } else if (drone.signs().yields() == null) {
            hang(draft, drone);
        }
    }

    private static void resume(Draft draft, RunDrone drone, Look look) {
        if (look.isDisarmed()) {
            draft.put(drone.flying(null, 0).to(DroneStage.LANDED, draft.now()));
        } else if (look.waits() && look.airborne()) {
            draft.put(drone.to(DroneStage.HOLDING, draft.now()));
        } else if (!look.airborne()) {
            draft.give(drone, Errand.Kind.DISARM, new Command.Disarm(false));
            return;
        } else {
            pause(draft, drone);
            return;
        }
        draft.cause(Trigger.RESUMED, drone.id(), drone.name() + " takes part again.");
    }

    /** It waits for a plan, and goes on where its mission leads to its own waypoints alone. */
    private static void hang(Draft draft, RunDrone drone) {
        Sortie sortie = drone.sortie();
        boolean planned = draft.request() == null && draft.causes().isEmpty() && draft.proposal() == null;
        if (planned && sortie != null && drone.orders().containsAll(sortie.ahead(drone.passed()))) {
            draft.put(drone.to(DroneStage.CONTINUING, draft.now()));
        } else if (Duration.between(drone.since(), draft.now()).compareTo(LONGEST_HOLD) > 0) {
            Faults.callHome(
                    draft, drone, Trigger.LATE, "There is no plan for " + drone.name() + "; it is called home.");
        }
    }

    private static void replace(Draft draft, RunDrone drone, Look look) {
        Sortie next = drone.next();
        if (look.isOnMission()) {
            pause(draft, drone.to(DroneStage.HOLDING, draft.now()));
        } else if (next == null) {
            draft.put(drone.to(DroneStage.HOLDING, draft.now()));
        } else if (isAmended(draft, drone, next, look)) {
            return;
        } else if (Boolean.TRUE.equals(look.progress().carriesNext())) {
            draft.put(onBoard(drone, next).to(DroneStage.CONTINUING, draft.now()));
        } else if (!Transfer.isFree(draft, drone, next)) {
            // A newer plan came while it was about to get the one before.
            draft.put(drone.to(DroneStage.HOLDING, draft.now()));
        } else {
            bring(draft, drone, next, look);
        }
    }

    /** Or may have to be: what it did of its last mission is not done again. */
    private static boolean isAmended(Draft draft, RunDrone drone, Sortie next, Look look) {
        return TaskReports.spare(draft, drone, next)
                || TaskReports.mayTellYet(draft, drone, look)
                || leavesOutWhatIsDone(draft, drone, next, look);
    }

    private static boolean leavesOutWhatIsDone(Draft draft, RunDrone drone, Sortie next, Look look) {
        Place place = look.place();
        Optional<Sortie> left = place == null ? Optional.empty() : Handing.left(draft, drone, next, place);
        left.ifPresent(sortie -> draft.put(drone.getting(sortie)));
        return left.isPresent();
    }

    private static void goOn(Draft draft, RunDrone drone, Look look) {
        if (look.isOnMission()) {
            draft.put(drone.to(DroneStage.FLYING, draft.now()));
        } else if (drone.next() != null) {
            draft.put(drone.to(DroneStage.HOLDING, draft.now()));
        } else {
            draft.give(drone, Errand.Kind.START, begin(draft, drone.passed() == 0));
        }
    }

    /** How long it stood before it was called does not count. */
    private static boolean isStuck(Draft draft, RunDrone drone, Look look) {
        Duration called = Duration.between(drone.since(), draft.now());
        return look.still().compareTo(LONGEST_STILL_ON_ITS_WAY_HOME) > 0
                && called.compareTo(LONGEST_STILL_ON_ITS_WAY_HOME) > 0;
    }

    private static void downAtHome(Draft draft, RunDrone drone, Look look) {
        if (!draft.stopping() && Silences.cameHome(drone, look)) {
            Silences.takesPartAgain(draft, drone);
        } else if (!Homeward.putBack(draft, drone)) {
            draft.put(drone.to(draft.stopping() ? DroneStage.LANDED : DroneStage.LEFT, draft.now()));
        }
    }

    private static void comeHome(Draft draft, RunDrone drone, Look look) {
        if (look.isDisarmed()) {
            downAtHome(draft, drone, look);
        } else if (isStuck(draft, drone, look)) {
            draft.say(Trigger.LATE, drone.id(), drone.name() + " is stuck on its way home.");
            draft.put(drone.noted("It is stuck on its way home.").to(DroneStage.LEFT, draft.now()));
        } else if (!look.comesDown() && drone.signs().yields() == null) {
            Command home = look.canReturn() ? new Command.ReturnToLaunch() : new Command.Land();
            boolean up = look.airborne();
            draft.give(
                    drone.tried(new RunDrone.Tries(0, draft.now().plus(BETWEEN_CALLS))),
                    up ? Errand.Kind.HOME : Errand.Kind.DISARM,
                    up ? home : new Command.Disarm(false));
        }
    }
}
