package org.dronemap.cognitive.operation.run;

import java.util.List;
import java.util.stream.Collectors;
import org.dronemap.cognitive.operation.run.model.RunDrone;

/** Formats counts and lists for a mission run's messages to users. */
final class RunMessages {
    private static final int MOST_NAMED = 8;

    private RunMessages() {}

    static String count(long number, String what) {
        return number + " " + what + (number == 1 ? "" : "s");
    }

    /** What one that is not heard may do, after "it": rovers and boats never fly. */
    static String mayGoOn(RunTransition draft, RunDrone drone) {
        return draft.isWordedBefore(2) || drone.profile().flies() ? "may still fly" : "may still be under way";
    }

    /** What one does that is to get a plan. */
    static String waits(RunTransition draft, RunDrone drone) {
        return draft.isWordedBefore(2) || drone.profile().flies() ? "waits in the air" : "waits";
    }

    /** "w1, w2 and 3 more". */
    static String list(List<String> all) {
        String named = all.stream().limit(MOST_NAMED).collect(Collectors.joining(", "));
        return all.size() <= MOST_NAMED ? named : named + " and " + (all.size() - MOST_NAMED) + " more";
    }
}
