package org.dronemap.cognitive.plan;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiPredicate;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.separation.Separation;
import org.dronemap.core.separation.VerticalMargin;

/**
 * Heights at which the drones of a plan fly home, whenever each of them leaves its tour: above all that others fly, and
 * far enough above each other wherever their ways come near each other. Pure.
 */
public final class WaysHome {
    /** Above its home; what rules let drones fly without special permission. */
    private static final double MOST_METERS = 120;
    /** Beside the least distance: heights are held to some decimetres. */
    private static final double ROOM_METERS = 1;

    private final List<WayHome> ways;
    private final Separation separation;
    private final Stack stack;
    private final Stack proof;

    /**
     * A shortage of ways home: fewer than the drones of a plan. Heights are above the home of the drone that has none.
     *
     * @param drones that fly at once
     * @param fitting so many of them have a way home
     * @param without one that has none
     * @param flownMeters the highest way among those near its own
     * @param isFlown that is a way of a tour; else as high as vehicles fly home unasked
     * @param ceilingMeters that zones set it
     * @param apartMeters from one layer to the next
     * @param unevenMeters the same where homes are not known to be level
     * @param besideMeters ways home that are so far apart share a layer
     */
    public record Shortage(
            int drones,
            int fitting,
            DroneId without,
            double flownMeters,
            boolean isFlown,
            double ceilingMeters,
            double apartMeters,
            double unevenMeters,
            double besideMeters) {}

    /** Heights above the sea of those that found room, and those that did not. */
    private record Stack(Map<DroneId, Double> heights, List<WayHome> without) {}

    private WaysHome(List<WayHome> ways, Separation separation) {
        this.ways = ways;
        this.separation = separation;
        Stack each = stacked((one, other) -> true, MOST_METERS);
        // A layer for each holds however the tours change; by their areas only where there is no other way.
        stack = each.without().isEmpty() ? each : stacked(this::areNear, MOST_METERS);
        proof = stack.without().isEmpty() ? stack : stacked(this::areNear, Double.POSITIVE_INFINITY);
    }

    /** {@code hovers}: drones that fly home straight at one height. Others come home another way. */
    public static WaysHome of(PlanningProblem problem, Plan plan, Predicate<DroneId> hovers) {
        Map<DroneId, Craft> crafts =
                problem.crafts().stream().collect(Collectors.toMap(Craft::id, Function.identity()));
        LocalPlane plane =
                new LocalPlane(problem.crafts().get(0).finish().place().point());
        List<WayHome> ways = new ArrayList<>();
        for (Tour tour : plan.tours()) {
            Craft craft = crafts.get(tour.drone());
            if (craft != null && hovers.test(craft.id()) && !tour.stops().isEmpty()) {
                ways.add(WayHome.of(craft, tour, problem.barriers(), plane));
            }
        }
        return new WaysHome(ways, problem.rules().separation());
    }

    /** Above its home; empty: there is none for it, or none that it needs. */
    public Optional<Double> height(DroneId drone) {
        return ways.stream()
                .filter(way -> way.drone().equals(drone))
                .findFirst()
                .flatMap(way -> Optional.ofNullable(stack.heights().get(drone)).map(way::aboveHome));
    }

    /** Empty: all have a way home. Without a ceiling there always is one. */
    public Optional<Shortage> shortage() {
        if (proof.without().isEmpty()) {
            return Optional.empty();
        }
        WayHome without = proof.without().get(0);
        List<WayHome> near =
                ways.stream().filter(way -> isNear(without, way, this::areNear)).toList();
        double flown = near.stream().mapToDouble(WayHome::topMeters).max().orElse(without.topMeters());
        double layer = separation.verticalMeters() + ROOM_METERS;
        double uneven = near.stream()
                .mapToDouble(way -> VerticalMargin.between(without.home(), way.home()))
                .max()
                .orElse(0);
        boolean usual = near.stream().anyMatch(way -> flown == way.home().altitudeAmslMeters() + WayHome.USUAL_METERS);
        return Optional.of(new Shortage(
                ways.size(),
                ways.size() - proof.without().size(),
                without.drone(),
                without.aboveHome(flown),
                !usual,
                without.aboveHome(without.ceilingMeters()),
                layer,
                layer + uneven,
                separation.horizontalMeters()));
    }

    /** Those with the least room first, then those with the most neighbours: they are the hardest to place. */
    private Stack stacked(BiPredicate<WayHome, WayHome> near, double mostMeters) {
        Map<DroneId, Long> neighbours = ways.stream()
                .collect(Collectors.toMap(
                        WayHome::drone,
                        way -> ways.stream()
                                .filter(other -> near.test(way, other))
                                .count()));
        List<WayHome> hardestFirst = ways.stream()
                .sorted(Comparator.comparingDouble(WayHome::ceilingMeters)
                        .thenComparing(way -> -neighbours.getOrDefault(way.drone(), 0L)))
                .toList();
        Map<DroneId, Double> heights = new HashMap<>();
        List<WayHome> without = new ArrayList<>();
        for (WayHome way : hardestFirst) {
            double height = lowest(way, heights, near);
            double ceiling = Math.min(way.ceilingMeters(), way.home().altitudeAmslMeters() + mostMeters);
            if (height <= ceiling) {
                heights.put(way.drone(), height);
            } else if (ways.stream().anyMatch(other -> !other.isSame(way) && near.test(way, other))) {
                without.add(way);
            }
        }
        return new Stack(heights, without);
    }

    /** The lowest free height for it beside those that have theirs. */
    private double lowest(WayHome way, Map<DroneId, Double> heights, BiPredicate<WayHome, WayHome> near) {
        List<WayHome> around =
                ways.stream().filter(other -> isNear(way, other, near)).toList();
        double height = way.wholeMeters(around.stream()
                .mapToDouble(other -> other.topMeters() + apart(way, other))
                .max()
                .orElse(way.topMeters()));
        boolean moved = true;
        while (moved && height <= way.ceilingMeters()) {
            double free = free(way, height, around, heights);
            moved = free > height;
            height = free;
        }
        return height;
    }

    /** The same height, or a higher one beyond whatever is in its way. */
    private double free(WayHome way, double height, List<WayHome> around, Map<DroneId, Double> heights) {
        double free = height;
        for (WayHome other : around) {
            Double taken = other.isSame(way) ? null : heights.get(other.drone());
            if (taken != null && Math.abs(taken - free) < apart(way, other)) {
                free = way.wholeMeters(taken + apart(way, other));
            }
        }
        for (WayHome.HeightRange range : way.blocked()) {
            if (range.contains(free)) {
                free = way.wholeMeters(range.high() + ROOM_METERS);
            }
        }
        return free;
    }

    private static boolean isNear(WayHome way, WayHome other, BiPredicate<WayHome, WayHome> near) {
        return other.isSame(way) || near.test(way, other);
    }

    private boolean areNear(WayHome one, WayHome other) {
        return one.area().distanceMeters(other.area()) < separation.horizontalMeters();
    }

    private double apart(WayHome one, WayHome other) {
        double margin = one.isSame(other) ? 0 : VerticalMargin.between(one.home(), other.home());
        return separation.verticalMeters() + ROOM_METERS + margin;
    }
}
