package org.dronemap.cognitive.operation.run;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.VehicleKind;

/** Lets drones join, rejoin and leave a mission run, and calls all of them home when a user stops it. */
final class RunMembership {
    private RunMembership() {}

    static void apply(RunTransition draft, RunInput.UserRequest wish) {
        if (wish instanceof RunInput.JoinDrone join) {
            join(draft, join.craft(), join.name(), join.kind(), join.by() + " let " + join.name() + " join.");
        } else if (wish instanceof RunInput.JoinFromPool join) {
            RunPoolDrones.joined(draft);
            join(draft, join.craft(), join.name(), join.kind(), join.name() + " of the pool joins. " + join.why());
        } else if (wish instanceof RunInput.NoPoolDrone none) {
            RunPoolDrones.noneLeft(draft, none.why());
        } else if (wish instanceof RunInput.ResumeDrone resume) {
            resume(draft, draft.drone(resume.drone()), resume.by());
        } else if (wish instanceof RunInput.GiveUpDrone give) {
            giveUp(draft, draft.drone(give.drone()), give.by());
        } else if (wish instanceof RunInput.Stop stop) {
            stop(draft, stop.by());
        }
    }

    private static void join(RunTransition draft, Craft craft, String name, VehicleKind kind, String words) {
        Double height = ReturnLayers.above(draft).of(craft, kind, 0);
        RunDrone drone = RunDrone.joining(new RunDrone.Profile(craft, name, kind, height), draft.now());
        draft.put(drone);
        draft.addCause(RunTrigger.JOINED, drone.id(), words);
    }

    /** Where it is shows when it is looked at next. */
    private static void resume(RunTransition draft, RunDrone drone, String by) {
        draft.put(drone.noted(null).with(drone.flags().held(false)).to(RunDroneStage.RESUMING, draft.now()));
        draft.explain(RunTrigger.RESUMED, drone.id(), by + " resumed " + drone.name() + ".");
    }

    private static void giveUp(RunTransition draft, RunDrone drone, String by) {
        String sentence = by + " took " + drone.name() + " out of the run.";
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
        Set<DroneId> armed = new HashSet<>();
        for (RunDrone drone : draft.drones()) {
            RunDroneStage stage = switch (drone.stage()) {
                case ARMING, STARTING, FLYING, HOLDING, REPLACING, CONTINUING, RESUMING -> RunDroneStage.RETURNING;
                case UPLOADING, READY -> RunDroneStage.LANDED;
                default -> drone.stage();
            };
            if (drone.stage() == RunDroneStage.ARMING && !draft.isWordedBefore(2)) {
                armed.add(drone.id());
            }
            RunDrone released = draft.release(drone, why);
            draft.put(stage == drone.stage() ? released : released.noted(why).to(stage, draft.now()));
        }
        for (RunWaypoint target : draft.targets()) {
            if (!target.state().isSettled()) {
                draft.put(target.to(RunWaypoint.State.UNSERVED, null, why));
            }
        }
        draft.explain(RunTrigger.STOPPED, null, why + whatTheyDo(draft, armed));
    }

    /** {@code armed}: those that had not set off yet. */
    private static String whatTheyDo(RunTransition draft, Set<DroneId> armed) {
        Predicate<RunDrone> returning = drone -> drone.stage() == RunDroneStage.RETURNING;
        Predicate<RunDrone> silent = drone -> drone.stage() == RunDroneStage.SILENT;
        Predicate<RunDrone> onTheGround = drone -> armed.contains(drone.id());
        Predicate<RunDrone> flies =
                drone -> draft.isWordedBefore(2) || drone.profile().flies();
        String words = doing(draft, returning.and(onTheGround.negate()), " comes home.", " come home.")
                + doing(draft, returning.and(onTheGround), " stays where it is.", " stay where they are.")
                + doing(
                        draft,
                        silent.and(flies),
                        " is not heard and may still fly.",
                        " are not heard and may still fly.")
                + doing(
                        draft,
                        silent.and(flies.negate()),
                        " is not heard and may still be under way.",
                        " are not heard and may still be under way.")
                + doing(
                        draft,
                        drone -> drone.stage() == RunDroneStage.SUSPENDED,
                        " is left to who has it.",
                        " are left to who has them.");
        return words.isEmpty() ? " No drone is under way." : words;
    }

    private static String doing(RunTransition draft, Predicate<RunDrone> which, String one, String more) {
        List<String> names =
                draft.drones().stream().filter(which).map(RunDrone::name).toList();
        return names.isEmpty() ? "" : " " + RunMessages.list(names) + (names.size() == 1 ? one : more);
    }
}
