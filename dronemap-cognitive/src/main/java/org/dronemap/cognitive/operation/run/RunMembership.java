package org.dronemap.cognitive.operation.run;

import java.util.List;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;

/** Lets drones join, rejoin and leave a mission run, and calls all of them home when a user stops it. */
final class RunMembership {
    private RunMembership() {}

    static void apply(RunTransition draft, RunInput.UserRequest wish) {
        if (wish instanceof RunInput.JoinDrone join) {
            Double height = ReturnLayers.above(draft).of(join.craft(), join.kind(), 0);
            RunDrone drone =
                    RunDrone.joining(new RunDrone.Profile(join.craft(), join.name(), join.kind(), height), draft.now());
            draft.put(drone);
            draft.addCause(RunTrigger.JOINED, drone.id(), join.by() + " let " + join.name() + " join.");
        } else if (wish instanceof RunInput.ResumeDrone resume) {
            resume(draft, draft.drone(resume.drone()), resume.by());
        } else if (wish instanceof RunInput.GiveUpDrone give) {
            giveUp(draft, draft.drone(give.drone()), give.by() + " took %s out of the run.");
        } else if (wish instanceof RunInput.Stop stop) {
            stop(draft, stop.by());
        }
    }

    /** Where it is shows when it is looked at next. */
    private static void resume(RunTransition draft, RunDrone drone, String by) {
        draft.put(drone.noted(null).with(drone.flags().held(false)).to(RunDroneStage.RESUMING, draft.now()));
        draft.explain(RunTrigger.RESUMED, drone.id(), by + " resumed " + drone.name() + ".");
    }

    private static void giveUp(RunTransition draft, RunDrone drone, String words) {
        String sentence = String.format(words, drone.name());
        RunDroneStage stage = switch (drone.stage()) {
            case ARMING, STARTING, FLYING, HOLDING, REPLACING, CONTINUING, RESUMING, RETURNING ->
                RunDroneStage.RETURNING;
            case SILENT -> RunDroneStage.GONE;
            default -> RunDroneStage.LEFT;
        };
        DroneWithdrawal.withdraw(draft, drone, stage, RunTrigger.GIVEN_UP, sentence);
    }

    private static void stop(RunTransition draft, String by) {
        draft.stopRun();
        draft.clock(draft.clock().paused(null));
        draft.request(null);
        draft.proposal(null);
        draft.causes().clear();
        String why = "The run was stopped by " + by + ".";
        for (RunDrone drone : draft.drones()) {
            RunDroneStage stage = switch (drone.stage()) {
                case ARMING, STARTING, FLYING, HOLDING, REPLACING, CONTINUING, RESUMING -> RunDroneStage.RETURNING;
                case UPLOADING, READY -> RunDroneStage.LANDED;
                default -> drone.stage();
            };
            RunDrone released = draft.release(drone, why);
            draft.put(stage == drone.stage() ? released : released.noted(why).to(stage, draft.now()));
        }
        for (RunWaypoint target : draft.targets()) {
            if (!target.state().isSettled()) {
                draft.put(target.to(RunWaypoint.State.UNSERVED, null, why));
            }
        }
        draft.explain(RunTrigger.STOPPED, null, why + whatTheyDo(draft));
    }

    private static String whatTheyDo(RunTransition draft) {
        String words = doing(draft, RunDroneStage.RETURNING, " comes home.", " come home.")
                + doing(
                        draft,
                        RunDroneStage.SILENT,
                        " is not heard and may still fly.",
                        " are not heard and may still fly.")
                + doing(draft, RunDroneStage.SUSPENDED, " is left to who has it.", " are left to who has them.");
        return words.isEmpty() ? " No drone is under way." : words;
    }

    private static String doing(RunTransition draft, RunDroneStage stage, String one, String more) {
        List<String> names = draft.drones().stream()
                .filter(drone -> drone.stage() == stage)
                .map(RunDrone::name)
                .toList();
        return names.isEmpty() ? "" : " " + RunMessages.list(names) + (names.size() == 1 ? one : more);
    }
}
