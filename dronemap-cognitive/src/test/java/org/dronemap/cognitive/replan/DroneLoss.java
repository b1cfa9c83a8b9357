package org.dronemap.cognitive.replan;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.allocate.SearchBudget;
import org.dronemap.cognitive.engine.FleetPlanner;
import org.dronemap.cognitive.plan.Plan;
import org.dronemap.cognitive.plan.TourStop;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Waypoint;

/** A plan for all drones, and the same problem without the first one. */
record DroneLoss(PlanningProblem problem, Plan plan, ReplanSituation situation) {
    static DroneLoss of(long seed, int waypoints, int drones) {
        SplittableRandom random = new SplittableRandom(seed);
        List<Waypoint> places = new ArrayList<>();
        for (int i = 0; i < waypoints; i++) {
            places.add(
                    PlanningFixtures.waypoint(i, random.nextDouble(-1_500, 1_500), random.nextDouble(-1_500, 1_500)));
        }
        PlanningProblem problem = PlanningProblem.of(places, PlanningFixtures.crafts(drones));
        Plan plan = FleetPlanner.plan(problem, seed, SearchBudget.iterations(5_000), progress -> {})
                .plan();
        List<Craft> left = problem.crafts().subList(1, drones);
        return new DroneLoss(problem, plan, new ReplanSituation(PlanningProblem.of(places, left), live(plan)));
    }

    static List<LiveAssignment> live(Plan plan) {
        return plan.tours().stream()
                .map(tour -> LiveAssignment.of(
                        tour.drone(),
                        tour.stops().stream().map(TourStop::waypoint).toList()))
                .toList();
    }
}
