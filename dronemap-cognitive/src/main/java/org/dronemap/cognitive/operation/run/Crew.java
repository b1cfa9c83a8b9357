package org.dronemap.cognitive.operation.run;

/** Drones that come, come back, go, and are all called home. */
final class Crew {
    private Crew() {}

    static void wish(Draft draft, RunInput.Wish wish) {
        if (wish instanceof RunInput.JoinDrone join) {
            Double height = ReturnHeights.above(draft).of(join.craft(), join.kind(), 0);
            RunDrone drone =
                    RunDrone.joining(new RunDrone.Kin(join.craft(), join.name(), join.kind(), height), draft.now());
            draft.put(drone);
            draft.cause(Trigger.JOINED, drone.id(), join.by() + " let " + join.name() + " join.");
        } else if (wish instanceof RunInput.ResumeDrone resume) {
            resume(draft, draft.drone(resume.drone()), resume.by());
        } else if (wish instanceof RunInput.GiveUpDrone give) {
            giveUp(draft, draft.drone(give.drone()), give.by() + " took %s out of the run.");
        } else if (wish instanceof RunInput.Stop stop) {
            stop(draft, stop.by());
        }
    }

    /** Where it is shows when it is looked at next. */
    private static void resume(Draft draft, RunDrone drone, String by) {
        draft.put(drone.noted(null).with(drone.signs().held(false)).to(DroneStage.RESUMING, draft.now()));
        draft.say(Trigger.RESUMED, drone.id(), by + " resumed " + drone.name() + ".");
    }

    private static void giveUp(Draft draft, RunDrone drone, String words) {
        String sentence = String.format(words, drone.name());
        DroneStage stage = switch (drone.stage()) {
            case ARMING, STARTING, FLYING, HOLDING, REPLACING, CONTINUING, RESUMING, RETURNING -> DroneStage.RETURNING;
            case SILENT -> DroneStage.GONE;
            default -> DroneStage.LEFT;
        };
        Faults.leave(draft, drone, stage, Trigger.GIVEN_UP, sentence);
    }

    private static void stop(Draft draft, String by) {
        draft.stop();
        draft.clock(draft.clock().paused(null));
        draft.request(null);
        draft.proposal(null);
        draft.causes().clear();
        String why = "The run was stopped by " + by + ".";
        for (RunDrone drone : draft.drones()) {
            DroneStage stage = switch (drone.stage()) {
                case ARMING, STARTING, FLYING, HOLDING, REPLACING, CONTINUING, RESUMING -> DroneStage.RETURNING;
                case UPLOADING, READY -> DroneStage.LANDED;
                default -> drone.stage();
            };
            RunDrone released = draft.release(drone, why);
            draft.put(stage == drone.stage() ? released : released.noted(why).to(stage, draft.now()));
        }
        for (Target target : draft.targets()) {
            if (!target.state().isSettled()) {
                draft.put(target.to(Target.State.UNSERVED, null, why));
            }
        }
        draft.say(Trigger.STOPPED, null, why + " All drones come home.");
    }
}
