package org.dronemap.cognitive.replan;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.dronemap.cognitive.Scenes;
import org.dronemap.cognitive.allocate.Budget;
import org.dronemap.cognitive.engine.Engine;
import org.dronemap.cognitive.plan.Plan;
import org.dronemap.cognitive.plan.Stop;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Problem;
import org.dronemap.cognitive.problem.Waypoint;

/** A plan for all drones, and the same problem without the first one. */
record Loss(Problem problem, Plan plan, Situation situation) {
    static Loss of(long seed, int waypoints, int drones) {
        SplittableRandom random = new SplittableRandom(seed);
        List<Waypoint> places = new ArrayList<>();
        for (int i = 0; i < waypoints; i++) {
            places.add(Scenes.waypoint(i, random.nextDouble(-1_500, 1_500), random.nextDouble(-1_500, 1_500)));
        }
        Problem problem = Problem.of(places, Scenes.crafts(drones));
        Plan plan = Engine.plan(problem, seed, Budget.iterations(5_000), progress -> {})
                .plan();
        List<Craft> left = problem.crafts().subList(1, drones);
        return new Loss(problem, plan, new Situation(Problem.of(places, left), live(plan)));
    }

    static List<LiveOrder> live(Plan plan) {
        return plan.tours().stream()
                .map(tour -> LiveOrder.of(
                        tour.drone(), tour.stops().stream().map(Stop::waypoint).toList()))
                .toList();
    }
}
