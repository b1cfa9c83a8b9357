package org.dronemap.cognitive.operation.run;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.dronemap.cognitive.operation.run.model.PendingReplan;
import org.dronemap.cognitive.operation.run.model.ReplanCause;
import org.dronemap.cognitive.plan.UnservedWaypoint;
import org.dronemap.cognitive.replan.ReassignedWaypoint;
import org.dronemap.cognitive.replan.ReplanResult;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/** Writes for users what a re-planning changes in a mission run, and why. */
final class PlanChangeMessages {
    private PlanChangeMessages() {}

    static String of(RunTransition draft, PendingReplan request, ReplanResult result) {
        List<String> parts = new ArrayList<>();
        request.causes().stream().map(ReplanCause::words).distinct().forEach(parts::add);
        parts.add(moved(draft, result.changes().moved()));
        leftOut(result.plan().unserved()).forEach(parts::add);
        parts.add(String.format(
                Locale.ROOT,
                "The last drone is back in %.0f s; before, %s, in %.0f s.",
                result.after().longestSeconds(),
                result.before().unserved() == 0 ? "all served" : result.before().unserved() + " not served",
                result.before().longestSeconds()));
        return String.join(" ", parts);
    }

    /** One sentence or two for each reason. */
    private static List<String> leftOut(List<UnservedWaypoint> all) {
        Map<String, List<String>> by = new LinkedHashMap<>();
        all.forEach(
                left -> by.computeIfAbsent(left.why(), key -> new ArrayList<>()).add(left.waypoint()));
        return by.entrySet().stream()
                .map(entry -> RunMessages.list(entry.getValue())
                        + (entry.getValue().size() == 1 ? " has" : " have") + " nobody: " + entry.getKey())
                .toList();
    }

    private static String moved(RunTransition draft, List<ReassignedWaypoint> moved) {
        if (moved.isEmpty()) {
            return "No waypoint changes its drone.";
        }
        Map<String, List<String>> by = new LinkedHashMap<>();
        for (ReassignedWaypoint each : moved) {
            String way = name(draft, each.from(), "nobody") + " to " + name(draft, each.to(), "nobody");
            by.computeIfAbsent(way, key -> new ArrayList<>()).add(each.waypoint());
        }
        return by.entrySet().stream()
                .map(entry -> RunMessages.list(entry.getValue()) + " from " + entry.getKey())
                .collect(Collectors.joining("; ", "Waypoints that move: ", "."));
    }

    private static String name(RunTransition draft, @Nullable DroneId drone, String nobody) {
        return drone == null ? nobody : draft.drone(drone).name();
    }

    static String turned(List<String> names) {
        return names.isEmpty() ? "" : " New missions for " + RunMessages.list(names) + ".";
    }
}
