package org.dronemap.cognitive.problem;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.stored.Stored;

/** A planning problem: waypoints, drones, barriers, wind, objective and rules. Never changes. */
@Stored(names = "waypoints crafts barriers wind objective rules")
public record PlanningProblem(
        List<Waypoint> waypoints,
        List<Craft> crafts,
        List<Barrier> barriers,
        UniformWind wind,
        Objective objective,
        PlanningRules rules) {
    public static final int MOST_WAYPOINTS = 100_000;
    public static final int MOST_CRAFTS = 1_000;
    /** Of all zones together, a circle having {@link Barrier#CIRCLE_TURNS}: more take too long to find ways between. */
    public static final int MOST_CORNERS = 4_000;
    /** From the first place to any other one, along either axis. */
    public static final double WIDEST_METERS = 200_000;

    private static final double STEEPEST_DEGREES = 85;

    public PlanningProblem {
        waypoints = List.copyOf(waypoints);
        crafts = List.copyOf(crafts);
        barriers = List.copyOf(barriers);
        Require.within("number of waypoints", waypoints.size(), 0, MOST_WAYPOINTS);
        Require.within("number of drones", crafts.size(), 1, MOST_CRAFTS);
        Require.within(
                "number of corners of all zones",
                barriers.stream().mapToInt(Barrier::turns).sum(),
                0,
                MOST_CORNERS);
        distinct("waypoint", waypoints.stream().map(Waypoint::id));
        distinct("drone", crafts.stream().map(craft -> craft.id().value()));
        near(waypoints, crafts);
    }

    /** In calm air without zones, all done as early as can be. */
    public static PlanningProblem of(List<Waypoint> waypoints, List<Craft> crafts) {
        return new PlanningProblem(
                waypoints, crafts, List.of(), UniformWind.CALM, Objective.earliestEnd(), PlanningRules.USUAL);
    }

    public PlanningProblem with(UniformWind other) {
        return new PlanningProblem(waypoints, crafts, barriers, other, objective, rules);
    }

    public PlanningProblem with(Objective other) {
        return new PlanningProblem(waypoints, crafts, barriers, wind, other, rules);
    }

    public PlanningProblem with(PlanningRules other) {
        return new PlanningProblem(waypoints, crafts, barriers, wind, objective, other);
    }

    public PlanningProblem withBarriers(List<Barrier> other) {
        return new PlanningProblem(waypoints, crafts, other, wind, objective, rules);
    }

    /** Whether a drone's link is good enough to plan with it. */
    public boolean trusts(Craft craft) {
        return craft.linkQuality() >= rules.leastLinkQuality();
    }

    private static void distinct(String what, Stream<String> ids) {
        Set<String> seen = new HashSet<>();
        ids.forEach(id -> {
            if (!seen.add(id)) {
                throw new IllegalArgumentException("the " + what + " " + id + " is named twice");
            }
        });
    }

    private static void near(List<Waypoint> waypoints, List<Craft> crafts) {
        Geodetic first = crafts.get(0).start().place().point();
        LocalPlane plane = new LocalPlane(first);
        waypoints.forEach(waypoint ->
                near(plane, "waypoint " + waypoint.id(), waypoint.place().point()));
        crafts.forEach(craft -> {
            near(
                    plane,
                    "the start of drone " + craft.id(),
                    craft.start().place().point());
            near(plane, "the end of drone " + craft.id(), craft.finish().place().point());
        });
    }

    private static void near(LocalPlane plane, String what, Geodetic point) {
        Require.within("latitude of " + what, point.latitudeDegrees(), -STEEPEST_DEGREES, STEEPEST_DEGREES);
        double meters = Math.max(
                Math.abs(plane.spot(point).eastMeters()),
                Math.abs(plane.spot(point).northMeters()));
        Require.within("metres from the first drone to " + what, meters, 0, WIDEST_METERS);
    }
}
