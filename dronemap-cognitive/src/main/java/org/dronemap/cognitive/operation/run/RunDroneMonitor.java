package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.time.Instant;
import org.dronemap.cognitive.operation.run.model.DroneObservation;
import org.dronemap.cognitive.operation.run.model.PendingReplan;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.cognitive.operation.run.model.Sortie;

/** Monitors one drone of a mission run by each observation: control, link, and whether it is still in the air. */
final class RunDroneMonitor {
    /** For control of a drone that has just come to the run, or was resumed. */
    private static final Duration UNTIL_HELD = Duration.ofSeconds(10);
    /** From an order that was carried out until that shows. */
    private static final Duration UNTIL_SEEN = Duration.ofSeconds(3);

    private RunDroneMonitor() {}

    static void observe(RunTransition draft, DroneObservation look) {
        updateFlags(draft, look);
        DroneObstacles.observe(draft, look);
        RunDrone drone = draft.drone(look.drone());
        if (draft.stopping() && drone.stage() == RunDroneStage.LANDED) {
            // It is anybody's again.
            return;
        }
        if (drone.stage().compareTo(RunDroneStage.RETURNING) <= 0 && isControlledByOthers(draft, drone, look)) {
            suspend(draft, drone, look);
        } else if (RunCloudLoss.isWaitedFor(draft, look)) {
            fallMeanwhile(draft, drone, look);
        } else {
            dispatch(draft, draft.drone(look.drone()), look);
        }
    }

    private static void dispatch(RunTransition draft, RunDrone drone, DroneObservation look) {
        if (drone.stage() == RunDroneStage.SILENT) {
            LostDrones.observe(draft, look);
        } else if (look.isLost()) {
            LostDrones.linkLost(draft, drone, look);
        } else if (look.isLive()) {
            checkStage(draft, drone, look);
        }
    }

    /** Whatever it carries and wherever it is to fly. */
    private static void fallMeanwhile(RunTransition draft, RunDrone drone, DroneObservation look) {
        if (look.isLive() && look.isArmed() && look.airborne() && drone.stage().mayFly()) {
            FlightHealth.checkFall(draft, drone, look);
        }
    }

    static void removed(RunTransition draft, RunDrone drone) {
        if (drone.stage() != RunDroneStage.LEFT) {
            DroneWithdrawal.withdraw(
                    draft, drone, RunDroneStage.LEFT, RunTrigger.REMOVED, drone.name() + " was taken away.");
        }
    }

    private static void updateFlags(RunTransition draft, DroneObservation look) {
        RunDrone drone = draft.drone(look.drone());
        RunDrone.Flags signs = drone.flags();
        if (!signs.held() && look.holder() == null) {
            signs = signs.held(true);
        }
        Integer percent = look.batteryPercent();
        double joules = drone.craft().supply().remainingJoules();
        if (signs.joulesPerPercent() == null && percent != null && percent > 0 && Double.isFinite(joules)) {
            signs = signs.joulesPerPercent(joules / percent);
        }
        if (!signs.equals(drone.flags())) {
            draft.put(drone.with(signs));
        }
        ReturnHeightOverride.recordPrevious(draft, draft.drone(drone.id()), look);
    }

    private static boolean isControlledByOthers(RunTransition draft, RunDrone drone, DroneObservation look) {
        if (look.holder() != null) {
            return drone.flags().held()
                    || Duration.between(drone.since(), draft.now()).compareTo(UNTIL_HELD) > 0;
        }
        if (!look.isLive() || drone.issuedCommand() != null) {
            return false;
        }
        boolean settled = Duration.between(drone.since(), draft.now()).compareTo(UNTIL_SEEN) > 0;
        return switch (drone.stage()) {
            case FLYING ->
                !HomeArrival.isDriven(drone, look)
                        && (look.isSteered() || (look.waits() && settled && look.giveWay() == null));
            case STARTING, HOLDING, REPLACING, CONTINUING, RETURNING -> look.isSteered();
            // It is armed in a mode that orders are taken in: somebody else armed it, and not for us.
            case ARMING -> look.isArmed() && look.isSteered() && look.ordersMode() != null;
            default -> false;
        };
    }

    private static void suspend(RunTransition draft, RunDrone drone, DroneObservation look) {
        String what = look.holder() == null
                ? drone.name() + " is in mode " + look.mode() + ", which this run did not ask for"
                : "Somebody who goes first has " + drone.name();
        String who = look.holder() == null ? "" : " " + look.holder();
        boolean idle = drone.orders().isEmpty() && !drone.stage().mayFly();
        DroneWithdrawal.withdraw(
                draft,
                drone,
                idle ? RunDroneStage.LEFT : RunDroneStage.SUSPENDED,
                RunTrigger.TAKEN_OVER,
                what + "; it is left alone until somebody resumes it here." + who);
    }

    private static void checkStage(RunTransition draft, RunDrone drone, DroneObservation look) {
        switch (drone.stage()) {
            case FLYING, HOLDING, REPLACING, CONTINUING -> inTheAir(draft, drone, look);
            case RETURNING -> {
                if (!HomeArrival.circles(draft, drone, look)) {
                    FlightHealth.checkFall(draft, drone, look);
                }
            }
            case UPLOADING, READY, ARMING -> onTheGround(draft, drone, look);
            case LANDED -> LostDrones.endSilenceOnTheGround(draft, drone);
            case CRASHED -> FlightHealth.checkCrashed(draft, drone, look);
            default -> {}
        }
    }

    private static void onTheGround(RunTransition draft, RunDrone drone, DroneObservation look) {
        boolean settled = Duration.between(drone.since(), draft.now()).compareTo(Duration.ofMinutes(1)) > 0;
        boolean stuck =
                settled && drone.stage() != RunDroneStage.READY && drone.issuedCommand() == null && !look.ready();
        if (stuck) {
            DroneWithdrawal.withdraw(
                    draft,
                    drone,
                    RunDroneStage.LEFT,
                    RunTrigger.COMMAND_FAILED,
                    "What " + drone.name() + " can do is not known; it stays on the ground.");
        }
    }

    private static void inTheAir(RunTransition draft, RunDrone drone, DroneObservation look) {
        if (look.isDisarmed()) {
            down(draft, drone, look);
        } else if (HomeArrival.circles(draft, drone, look)) {
            return;
        } else if (look.comesDown() && !goesHomeByPlan(drone)) {
            DroneWithdrawal.withdraw(
                    draft,
                    drone,
                    RunDroneStage.RETURNING,
                    RunTrigger.WENT_HOME,
                    drone.name() + " comes home or down"
                            + (draft.isWordedBefore(2)
                                    ? " by itself (" + look.mode() + ")."
                                    : " (" + look.mode() + "), which this run did not ask for."));
        } else if (FlightHealth.checkFall(draft, drone, look)) {
            return;
        } else if (look.fallingLink() != null && !goesHomeByPlan(drone)) {
            DroneWithdrawal.callHome(
                    draft,
                    drone,
                    RunTrigger.LINK_FALLING,
                    drone.name() + " is called home before its link is lost. " + look.fallingLink());
        } else if (draft.drone(drone.id()).stage() == RunDroneStage.FLYING) {
            FlightHealth.check(draft, draft.drone(drone.id()), look);
        } else {
            FlightHealth.checkWaiting(draft, draft.drone(drone.id()), look);
        }
    }

    private static boolean goesHomeByPlan(RunDrone drone) {
        return drone.stage() == RunDroneStage.FLYING && drone.orders().isEmpty();
    }

    private static void down(RunTransition draft, RunDrone drone, DroneObservation look) {
        Double above = look.aboveHomeMeters();
        boolean high = above != null && above > FlightHealth.CLEARLY_UP_METERS && look.airborne();
        Sortie sortie = drone.sortie();
        boolean done = drone.orders().isEmpty() && drone.next() == null;
        if (done && !high) {
            draft.put(drone.withSortie(null, 0).to(RunDroneStage.LANDED, draft.now()));
        } else if (look.isAtTheEnd() && !high) {
            String words = drone.name() + " flew its mission to the end before it got the next one.";
            DroneWithdrawal.withdraw(
                    draft, drone.withSortie(null, 0), RunDroneStage.LANDED, RunTrigger.CAME_DOWN, words);
        } else if (sortie == null || !high) {
            DroneWithdrawal.withdraw(
                    draft,
                    drone,
                    RunDroneStage.LEFT,
                    RunTrigger.CAME_DOWN,
                    drone.name()
                            + (drone.profile().flies()
                                    ? " came down before its end."
                                    : " was disarmed before its end."));
        } else {
            FlightHealth.crashed(draft, drone, "its motors stopped in the air");
        }
    }

    /** Nothing is known of commands that were under way, and nobody was heard yet. */
    static void restarted(RunTransition draft, Duration grace) {
        Instant then = draft.now().plus(Duration.ofSeconds(3));
        for (RunDrone drone : draft.drones()) {
            if (drone.issuedCommand() != null) {
                draft.put(drone.tried(
                        new RunDrone.Attempts(Math.max(1, drone.attempts().failed()), then)));
            }
        }
        RunCloudLoss.markUnclear(draft);
        draft.clock(draft.clock().withLossAfter(draft.now().plus(grace)));
        PendingReplan open = draft.request();
        if (open != null) {
            draft.causes().addAll(0, open.causes());
            draft.request(null);
        }
        draft.explain(
                RunTrigger.RESTARTED, null, "The server was started again; the run goes on from what the drones say.");
    }
}
