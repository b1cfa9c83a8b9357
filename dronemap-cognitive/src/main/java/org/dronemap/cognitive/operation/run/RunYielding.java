package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.util.Objects;
import org.dronemap.cognitive.operation.run.model.DroneObservation;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.core.separation.GiveWay;

/** Has drones of a mission run wait while they give way to others, and go on when those have passed. */
final class RunYielding {
    private static final Duration LONGEST_YIELD = Duration.ofSeconds(15);

    private RunYielding() {}

    static void update(RunTransition draft, DroneObservation look) {
        RunDrone drone = draft.drone(look.drone());
        GiveWay give = look.giveWay();
        if (give == null) {
            goOn(draft, drone, look);
        } else if (give.manner() == GiveWay.Manner.WAIT) {
            doNotSetOff(draft, drone, give);
        } else {
            stand(draft, drone, look, give);
        }
    }

    private static void doNotSetOff(RunTransition draft, RunDrone drone, GiveWay give) {
        switch (drone.stage()) {
            case READY, ARMING -> {
                if (drone.flags().waitsFor() == null) {
                    draft.explain(RunTrigger.TOO_NEAR, drone.id(), give.sentence(drone.name()));
                }
                draft.put(drone.with(drone.flags().waitsFor(give.to())));
            }
            case CONTINUING -> {
                if (drone.issuedCommand() == null && drone.next() == null) {
                    draft.put(drone.with(drone.flags().waitsFor(give.to())).to(RunDroneStage.HOLDING, draft.now()));
                }
            }
            case HOLDING -> askForAnotherWay(draft, drone);
            default -> {}
        }
    }

    /** Told in flight: it stands as soon as it is seen to. */
    private static void stand(RunTransition draft, RunDrone drone, DroneObservation look, GiveWay give) {
        boolean concerned = switch (drone.stage()) {
            case FLYING, HOLDING, REPLACING, CONTINUING, RETURNING -> true;
            default -> false;
        };
        if (!concerned) {
            return;
        }
        explain(draft, drone, give);
        if (!look.waits()) {
            return;
        }
        if (give.clear()) {
            goOn(draft, draft.drone(drone.id()), look);
            return;
        }
        RunDrone waiting = draft.drone(drone.id());
        RunDrone marked = waiting.with(waiting.flags().waitsFor(give.to()));
        switch (marked.stage()) {
            case FLYING -> draft.put(marked.to(RunDroneStage.HOLDING, draft.now()));
            case CONTINUING ->
                draft.put(marked.issuedCommand() == null ? marked.to(RunDroneStage.HOLDING, draft.now()) : marked);
            case HOLDING -> askForAnotherWay(draft, marked);
            default -> draft.put(marked);
        }
    }

    private static void explain(RunTransition draft, RunDrone drone, GiveWay give) {
        boolean moves = give.manner() == GiveWay.Manner.MOVE;
        boolean anew = !Objects.equals(give.to(), drone.flags().waitsFor())
                || (moves && give.since().isAfter(drone.since()));
        if (!anew || give.clear()) {
            return;
        }
        draft.explain(RunTrigger.TOO_NEAR, drone.id(), give.sentence(drone.name()));
        RunDrone marked = drone.with(drone.flags().waitsFor(give.to()));
        boolean begins = moves && drone.issuedCommand() == null;
        draft.put(begins ? marked.to(marked.stage(), draft.now()) : marked);
    }

    /** Who cannot pass gets another plan; who is on its way home comes over the others. */
    private static void askForAnotherWay(RunTransition draft, RunDrone drone) {
        boolean late = Duration.between(drone.since(), draft.now()).compareTo(LONGEST_YIELD) > 0;
        if (late && drone.flags().waitsFor() != null && !draft.isPaused()) {
            draft.put(drone.to(RunDroneStage.HOLDING, draft.now()));
            draft.addCause(RunTrigger.TOO_NEAR, drone.id(), drone.name() + " cannot pass; another way is looked for.");
        } else {
            draft.put(drone);
        }
    }

    private static void goOn(RunTransition draft, RunDrone drone, DroneObservation look) {
        boolean stopped = drone.stage() == RunDroneStage.FLYING && look.giveWay() != null && look.waits();
        if (drone.flags().waitsFor() == null && !stopped) {
            return;
        }
        RunDrone free = drone.with(drone.flags().waitsFor(null));
        boolean goes = (stopped || drone.stage() == RunDroneStage.HOLDING)
                && drone.issuedCommand() == null
                && drone.next() == null
                && look.waits()
                && !draft.isPaused();
        draft.put(goes ? free.to(RunDroneStage.CONTINUING, draft.now()) : free);
    }
}
