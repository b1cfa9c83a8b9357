package org.dronemap.cognitive.cost;

import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Waypoint;

/** Decides which drones could visit a waypoint if it were their only one, and says why none can. Never changes. */
final class WaypointFeasibility {
    private final PlanningProblem problem;
    private final DroneTypes fleet;
    private final Legs legs;
    private final Detours detours;
    private final double[] ranges;

    /** {@code legs}: those of the problem, or where these take too long shorter ones. */
    WaypointFeasibility(PlanningProblem problem, DroneTypes fleet, Legs legs, Detours detours, double[] ranges) {
        this.problem = problem;
        this.fleet = fleet;
        this.legs = legs;
        this.detours = detours;
        this.ranges = ranges;
    }

    BitSet drones(int waypoint) {
        BitSet drones = new BitSet();
        for (int drone = 0; drone < problem.crafts().size(); drone++) {
            if (isEligible(drone, waypoint)
                    && isReachable(drone, waypoint)
                    && isInTime(drone, waypoint)
                    && joules(drone, waypoint) <= ranges[drone]) {
                drones.set(drone);
            }
        }
        return drones;
    }

    private boolean isEligible(int drone, int waypoint) {
        Craft craft = problem.crafts().get(drone);
        return problem.trusts(craft)
                && craft.can(problem.waypoints().get(waypoint).task());
    }

    private boolean isReachable(int drone, int waypoint) {
        return detours.obstacle(fleet.typeOf(drone), waypoint) == null
                && arrival(drone, waypoint) < Double.POSITIVE_INFINITY
                && legs.seconds(fleet.typeOf(drone), waypoint, end(drone)) < Double.POSITIVE_INFINITY;
    }

    private boolean isInTime(int drone, int waypoint) {
        return arrival(drone, waypoint)
                <= problem.waypoints().get(waypoint).window().closesSeconds();
    }

    private double arrival(int drone, int waypoint) {
        return problem.crafts().get(drone).start().readySeconds()
                + legs.seconds(fleet.typeOf(drone), start(drone), waypoint);
    }

    /** There, the task, and to the end. */
    private double joules(int drone, int waypoint) {
        Waypoint wanted = problem.waypoints().get(waypoint);
        int type = fleet.typeOf(drone);
        double waits = Math.max(0, wanted.window().opensSeconds() - arrival(drone, waypoint));
        return legs.joules(type, start(drone), waypoint)
                + (waits + wanted.task().serviceSeconds()) * fleet.paceOf(drone).hoverWatts()
                + legs.joules(type, waypoint, end(drone));
    }

    private int start(int drone) {
        return problem.waypoints().size() + 2 * drone;
    }

    private int end(int drone) {
        return start(drone) + 1;
    }

    /** A sentence, when no drone can; the reason is that of the drone that fails last. */
    Optional<String> whyNobody(int waypoint) {
        List<Craft> crafts = problem.crafts();
        BitSet left = new BitSet();
        left.set(0, crafts.size());
        keep(left, drone -> problem.trusts(crafts.get(drone)));
        if (left.isEmpty()) {
            return Optional.of(String.format(
                    Locale.ROOT,
                    "No drone has a link that is good enough (%.2f is asked for).",
                    problem.rules().leastLinkQuality()));
        }
        Waypoint wanted = problem.waypoints().get(waypoint);
        keep(left, drone -> crafts.get(drone).can(wanted.task()));
        if (left.isEmpty()) {
            return Optional.of("No drone in good contact can " + wants(wanted) + ".");
        }
        String obstacle = detours.obstacle(fleet.typeOf(left.nextSetBit(0)), waypoint);
        keep(left, drone -> isReachable(drone, waypoint));
        if (left.isEmpty() && obstacle != null) {
            return Optional.of("It lies where " + obstacle + " keeps drones from.");
        }
        if (left.isEmpty()) {
            return Optional.of("No way leads there and on to the end of any drone that could serve it: zones, or the"
                    + " wind, are in the way.");
        }
        return whyNobodyFlies(waypoint, left);
    }

    private Optional<String> whyNobodyFlies(int waypoint, BitSet left) {
        BitSet flying = (BitSet) left.clone();
        keep(left, drone -> isInTime(drone, waypoint));
        if (left.isEmpty()) {
            double earliest = flying.stream()
                    .mapToDouble(drone -> arrival(drone, waypoint))
                    .min()
                    .orElse(Double.POSITIVE_INFINITY);
            return Optional.of(String.format(
                    Locale.ROOT,
                    "No drone is there in time: the first after %.0f s, the window closes after %.0f s.",
                    earliest,
                    problem.waypoints().get(waypoint).window().closesSeconds()));
        }
        int best = mostLeft(waypoint, left);
        return joules(best, waypoint) <= ranges[best] ? Optional.empty() : Optional.of(outOfRange(waypoint, best));
    }

    private String outOfRange(int waypoint, int best) {
        return String.format(
                Locale.ROOT,
                "Out of range: even the drone that has most to spare would draw %.1f Wh for it alone and may draw %.1f Wh.",
                joules(best, waypoint) / 3_600,
                ranges[best] / 3_600);
    }

    private int mostLeft(int waypoint, BitSet drones) {
        int best = drones.nextSetBit(0);
        for (int drone = best; drone >= 0; drone = drones.nextSetBit(drone + 1)) {
            if (ranges[drone] - joules(drone, waypoint) > ranges[best] - joules(best, waypoint)) {
                best = drone;
            }
        }
        return best;
    }

    private static String wants(Waypoint waypoint) {
        return String.join(
                " and ",
                waypoint.task().needs().stream()
                        .map(skill -> skill.words())
                        .sorted()
                        .toList());
    }

    private interface DroneTest {
        boolean holds(int drone);
    }

    private static void keep(BitSet drones, DroneTest test) {
        for (int drone = drones.nextSetBit(0); drone >= 0; drone = drones.nextSetBit(drone + 1)) {
            if (!test.holds(drone)) {
                drones.clear(drone);
            }
        }
    }
}
