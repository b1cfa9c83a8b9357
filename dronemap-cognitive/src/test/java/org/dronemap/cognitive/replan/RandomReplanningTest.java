package org.dronemap.cognitive.replan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dronemap.cognitive.replan.ReplannerTest.SHORT;
import static org.dronemap.cognitive.replan.ReplannerTest.drone;
import static org.dronemap.cognitive.replan.ReplannerTest.ids;
import static org.dronemap.cognitive.replan.ReplannerTest.inFlight;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.engine.FleetPlanner;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.EnergyBudget;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Task;
import org.dronemap.cognitive.problem.TimeWindow;
import org.dronemap.cognitive.problem.Waypoint;
import org.junit.jupiter.api.Test;

/** Changes of plans in situations drawn by chance: nothing is lost and nothing is flown twice. */
class RandomReplanningTest {

    @Test
    void neverLosesAWaypointWhateverHappens() {
        SplittableRandom random = new SplittableRandom(12);
        for (int round = 0; round < 60; round++) {
            ReplanSituation situation = anySituation(random);
            Replanner replanning = FleetPlanner.replanning(situation);
            for (ReplanResult replanned : List.of(replanning.atOnce(), replanning.improve(round, SHORT))) {
                List<String> told = new ArrayList<>();
                replanned.plan().tours().forEach(tour -> tour.stops().forEach(stop -> told.add(stop.waypoint())));
                replanned.plan().unserved().forEach(one -> told.add(one.waypoint()));

                assertThat(told)
                        .as("round %d", round)
                        .containsExactlyInAnyOrderElementsOf(situation.problem().waypoints().stream()
                                .map(Waypoint::id)
                                .toList());
                assertThat(replanned.faults())
                        .as("round %d", round)
                        .filteredOn(fault -> !fault.contains("m apart"))
                        .isEmpty();
                assertThat(replanned.after().unserved())
                        .isEqualTo(replanned.plan().unserved().size());
            }
        }
    }

    /** Drones in the air and on the ground, some with little left, windows, one drone gone, new and cancelled waypoints. */
    private static ReplanSituation anySituation(SplittableRandom random) {
        List<Waypoint> waypoints = new ArrayList<>();
        for (int i = 0; i < 25; i++) {
            double opens = random.nextInt(3) == 0 ? random.nextDouble(300) : 0;
            double closes = random.nextInt(3) == 0 ? opens + random.nextDouble(600) : Double.POSITIVE_INFINITY;
            waypoints.add(new Waypoint(
                    "w" + i,
                    PlanningFixtures.place(random.nextDouble(-1_500, 1_500), random.nextDouble(-1_500, 1_500), 450),
                    new Task(random.nextInt(5), Set.of()),
                    1 + random.nextInt(3),
                    new TimeWindow(opens, closes)));
        }
        List<Craft> crafts = new ArrayList<>();
        for (int r = 0; r < 4; r++) {
            Craft craft = PlanningFixtures.craft(r, 500 * r, 0);
            craft = random.nextBoolean() ? inFlight(craft, 500 * r, random.nextDouble(-800, 800)) : craft;
            crafts.add(
                    random.nextInt(3) == 0
                            ? craft.with(EnergyBudget.ofWattHours(random.nextDouble(20, 60), 2))
                            : craft);
        }
        List<LiveAssignment> live = new ArrayList<>();
        for (int r = 0; r < 5; r++) {
            live.add(new LiveAssignment(drone(r), ids(6 * r), ids(6 * r + 1, 6 * r + 2, 6 * r + 3, 6 * r + 4)));
        }
        return new ReplanSituation(PlanningProblem.of(waypoints, crafts), live);
    }
}
