package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.time.Instant;

/** Monitors one drone by each observation: control, link, and whether it is still in the air. */
final class Watch {
    /** For control of a drone that has just come to the run, or was resumed. */
    private static final Duration UNTIL_HELD = Duration.ofSeconds(10);
    /** From an order that was carried out until that shows. */
    private static final Duration UNTIL_SEEN = Duration.ofSeconds(3);

    private Watch() {}

    static void look(Draft draft, Look look) {
        learn(draft, look);
        Obstacles.look(draft, look);
        RunDrone drone = draft.drone(look.drone());
        if (drone.stage().compareTo(DroneStage.RETURNING) <= 0 && isTaken(draft, drone, look)) {
            suspend(draft, drone, look);
        } else if (Absence.isWaitedFor(draft, look)) {
            fallMeanwhile(draft, drone, look);
        } else {
            follow(draft, draft.drone(look.drone()), look);
        }
    }

    private static void follow(Draft draft, RunDrone drone, Look look) {
        if (drone.stage() == DroneStage.SILENT) {
            Silences.look(draft, look);
        } else if (look.isLost()) {
            Silences.begin(draft, drone, look);
        } else if (look.isLive()) {
            whereItIs(draft, drone, look);
        }
    }

    /** Whatever it carries and wherever it is to fly. */
    private static void fallMeanwhile(Draft draft, RunDrone drone, Look look) {
        if (look.isLive() && look.isArmed() && look.airborne() && drone.stage().mayFly()) {
            Condition.fall(draft, drone, look);
        }
    }

    static void removed(Draft draft, RunDrone drone) {
        if (drone.stage() != DroneStage.LEFT) {
            Faults.leave(draft, drone, DroneStage.LEFT, Trigger.REMOVED, drone.name() + " was taken away.");
        }
    }

    private static void learn(Draft draft, Look look) {
        RunDrone drone = draft.drone(look.drone());
        RunDrone.Signs signs = drone.signs();
        if (!signs.held() && look.takenBy() == null) {
            signs = signs.held(true);
        }
        Integer percent = look.batteryPercent();
        double joules = drone.craft().supply().remainingJoules();
        if (signs.joulesPerPercent() == null && percent != null && percent > 0 && Double.isFinite(joules)) {
            signs = signs.joulesPerPercent(joules / percent);
        }
        if (!signs.equals(drone.signs())) {
            draft.put(drone.with(signs));
        }
        Homeward.learn(draft, draft.drone(drone.id()), look);
    }

    private static boolean isTaken(Draft draft, RunDrone drone, Look look) {
        if (look.takenBy() != null) {
            return drone.signs().held()
                    || Duration.between(drone.since(), draft.now()).compareTo(UNTIL_HELD) > 0;
        }
        if (!look.isLive() || drone.errand() != null) {
            return false;
        }
        boolean settled = Duration.between(drone.since(), draft.now()).compareTo(UNTIL_SEEN) > 0;
        return switch (drone.stage()) {
            case FLYING -> look.isSteered() || (look.waits() && settled);
            case STARTING, HOLDING, REPLACING, CONTINUING, RETURNING -> look.isSteered();
            // It is armed in a mode that orders are taken in: somebody else armed it, and not for us.
            case ARMING -> look.isArmed() && look.isSteered() && look.ordersMode() != null;
            default -> false;
        };
    }

    private static void suspend(Draft draft, RunDrone drone, Look look) {
        String what = look.takenBy() == null
                ? drone.name() + " is in mode " + look.mode() + ", which this run did not ask for"
                : "Somebody who goes first has " + drone.name();
        String who = look.takenBy() == null ? "" : " " + look.takenBy();
        boolean idle = drone.orders().isEmpty() && !drone.stage().mayFly();
        Faults.leave(
                draft,
                drone,
                idle ? DroneStage.LEFT : DroneStage.SUSPENDED,
                Trigger.TAKEN_OVER,
                what + "; it is left alone until somebody resumes it here." + who);
    }

    private static void whereItIs(Draft draft, RunDrone drone, Look look) {
        switch (drone.stage()) {
            case FLYING, HOLDING, REPLACING, CONTINUING -> inTheAir(draft, drone, look);
            case RETURNING -> Condition.fall(draft, drone, look);
            case UPLOADING, READY, ARMING -> onTheGround(draft, drone, look);
            case CRASHED -> Condition.afterAll(draft, drone, look);
            default -> {}
        }
    }

    private static void onTheGround(Draft draft, RunDrone drone, Look look) {
        boolean settled = Duration.between(drone.since(), draft.now()).compareTo(Duration.ofMinutes(1)) > 0;
        boolean stuck = settled && drone.stage() != DroneStage.READY && drone.errand() == null && !look.ready();
        if (stuck) {
            Faults.leave(
                    draft,
                    drone,
                    DroneStage.LEFT,
                    Trigger.COMMAND_FAILED,
                    "What " + drone.name() + " can do is not known; it stays on the ground.");
        }
    }

    private static void inTheAir(Draft draft, RunDrone drone, Look look) {
        if (look.isDisarmed()) {
            down(draft, drone, look);
        } else if (look.comesDown() && !goesHomeByPlan(drone)) {
            Faults.leave(
                    draft,
                    drone,
                    DroneStage.RETURNING,
                    Trigger.WENT_HOME,
                    drone.name() + " comes home or down by itself (" + look.mode() + ").");
        } else if (Condition.fall(draft, drone, look)) {
            return;
        } else if (draft.drone(drone.id()).stage() == DroneStage.FLYING) {
            Condition.check(draft, draft.drone(drone.id()), look);
        } else {
            Condition.whileItWaits(draft, draft.drone(drone.id()), look);
        }
    }

    private static boolean goesHomeByPlan(RunDrone drone) {
        return drone.stage() == DroneStage.FLYING && drone.orders().isEmpty();
    }

    private static void down(Draft draft, RunDrone drone, Look look) {
        Double above = look.aboveHomeMeters();
        boolean high = above != null && above > Condition.CLEARLY_UP_METERS && look.airborne();
        Sortie sortie = drone.sortie();
        boolean done = drone.orders().isEmpty() && drone.next() == null;
        if (done && !high) {
            draft.put(drone.flying(null, 0).to(DroneStage.LANDED, draft.now()));
        } else if (look.isAtTheEnd() && !high) {
            String words = drone.name() + " flew its mission to the end before it got the next one.";
            Faults.leave(draft, drone.flying(null, 0), DroneStage.LANDED, Trigger.CAME_DOWN, words);
        } else if (sortie == null || !high) {
            Faults.leave(draft, drone, DroneStage.LEFT, Trigger.CAME_DOWN, drone.name() + " came down before its end.");
        } else {
            Condition.crashed(draft, drone, "its motors stopped in the air");
        }
    }

    /** Nothing is known of commands that were under way, and nobody was heard yet. */
    static void restarted(Draft draft, Duration grace) {
        Instant then = draft.now().plus(Duration.ofSeconds(3));
        for (RunDrone drone : draft.drones()) {
            if (drone.errand() != null) {
                draft.put(
                        drone.tried(new RunDrone.Tries(Math.max(1, drone.tries().failed()), then)));
            }
        }
        Absence.begin(draft);
        draft.clock(draft.clock().hearing(draft.now().plus(grace)));
        Request open = draft.request();
        if (open != null) {
            draft.causes().addAll(0, open.causes());
            draft.request(null);
        }
        draft.say(Trigger.RESTARTED, null, "The server was started again; the run goes on from what the drones say.");
    }
}
