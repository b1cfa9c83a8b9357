package org.dronemap.cognitive.operation.run;

import java.util.Objects;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunPool;
import org.dronemap.cognitive.operation.run.model.RunTrigger;

/** Replaces lost drones of a mission run by others of the pool, as long as its drones were not named. */
final class RunPoolDrones {
    private RunPoolDrones() {}

    static void joined(RunTransition draft) {
        RunPool pool = draft.setting().pool();
        if (pool != null) {
            draft.setting(draft.setting().with(new RunPool(pool.upTo(), null)));
        }
    }

    /** Told once, until one joins after all. */
    static void noneLeft(RunTransition draft, String why) {
        RunPool pool = draft.setting().pool();
        if (pool != null && !Objects.equals(pool.whyNone(), why)) {
            boolean told = pool.whyNone() != null;
            draft.setting(draft.setting().with(new RunPool(pool.upTo(), why)));
            if (!told) {
                draft.explain(RunTrigger.LOST, null, "No other drone of the pool can join. " + why);
            }
        }
    }

    /** Its waypoints wait for a drone that is looked for. */
    static boolean mayJoin(RunTransition draft) {
        RunPool pool = draft.setting().pool();
        return pool != null
                && pool.whyNone() == null
                && !draft.stopping()
                && draft.drones().stream().filter(RunPoolDrones::counts).count() < pool.upTo();
    }

    /** It flies for the run, or can. */
    static boolean counts(RunDrone drone) {
        return drone.stage().acceptsCommands();
    }

    /** Why nobody was left for a waypoint, as one or more sentences. */
    static String leftover(RunTransition draft) {
        RunPool pool = draft.setting().pool();
        return pool == null || pool.whyNone() == null
                ? "No drone was left for it."
                : "No drone was left for it, and none of the pool could join. " + pool.whyNone();
    }
}
