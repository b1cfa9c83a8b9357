package org.dronemap.cognitive.allocate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.cost.CostModel;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.EnergyBudget;
import org.dronemap.cognitive.problem.Objective;
import org.dronemap.cognitive.problem.Performance;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Speeds;
import org.dronemap.cognitive.problem.Start;
import org.dronemap.cognitive.problem.Task;
import org.dronemap.cognitive.problem.TimeWindow;
import org.dronemap.cognitive.problem.UniformWind;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.zone.AltitudeBand;
import org.junit.jupiter.api.Test;

/** Missions on the map with batteries, speeds, windows, wind and fences, small enough to try every plan. */
class TinyMissionsTest {
    private final SplittableRandom random = new SplittableRandom(41);

    @Test
    void findsTheBestOfAllPlansOfAThousandTinyMissions() {
        int fenced = 0;
        int incomplete = 0;
        for (int mission = 0; mission < 1_000; mission++) {
            PlanningProblem problem = mission(1 + mission % 4, 1 + mission % 3);
            CostModel costs = CostModel.of(problem);
            AllocationOracle judge = new AllocationOracle(costs.instance());
            AllocationOracle.Expectation best = BruteForcePlans.best(costs.instance());
            Allocation found =
                    new Allocator(costs.instance()).search(mission, SearchBudget.iterations(1_000), better -> {});

            assertThat(judge.faults(found.orders())).as("mission %d", mission).isEmpty();
            assertThat(judge.verdict(found.orders()).isWorseThan(best))
                    .as("mission %d: %s against %s", mission, judge.verdict(found.orders()), best)
                    .isFalse();
            CostModel open = CostModel.of(problem.withBarriers(List.of()));
            fenced += costs.plan(found.orders()).equals(open.plan(found.orders())) ? 0 : 1;
            incomplete += found.unserved().length > 0 ? 1 : 0;
        }
        assertThat(fenced).as("ways lead round zones").isGreaterThan(150);
        assertThat(incomplete).as("not all can be served").isBetween(50, 950);
    }

    private double anywhere() {
        return random.nextDouble(-900, 900);
    }

    private PlanningProblem mission(int waypoints, int drones) {
        List<Waypoint> places = new ArrayList<>();
        for (int i = 0; i < waypoints; i++) {
            double opens = random.nextInt(3) == 0 ? random.nextDouble(200) : 0;
            double closes = random.nextInt(3) == 0 ? opens + random.nextDouble(300) : Double.POSITIVE_INFINITY;
            places.add(new Waypoint(
                    "w" + i,
                    PlanningFixtures.place(anywhere(), anywhere(), random.nextDouble(420, 470)),
                    new Task(random.nextInt(20), Set.of()),
                    1 + random.nextInt(5),
                    new TimeWindow(opens, closes)));
        }
        List<Craft> crafts = new ArrayList<>();
        for (int r = 0; r < drones; r++) {
            crafts.add(craft(r));
        }
        List<Barrier> barriers = new ArrayList<>();
        for (int i = random.nextInt(3); i > 0; i--) {
            barriers.add(new Barrier(
                    "zone " + i,
                    new FenceArea.Circle(
                            false, PlanningFixtures.point(anywhere(), anywhere()), random.nextDouble(50, 300)),
                    AltitudeBand.ALL,
                    Set.of()));
        }
        Objective objective = random.nextBoolean()
                ? Objective.earliestEnd()
                : new Objective(random.nextInt(2), Objective.Measure.JOULES, 0.01, random.nextInt(4) == 0);
        return PlanningProblem.of(places, crafts)
                .withBarriers(barriers)
                .with(new UniformWind(random.nextInt(8), random.nextInt(360)))
                .with(objective);
    }

    private Craft craft(int number) {
        Performance usual = random.nextBoolean() ? PlanningFixtures.copter() : PlanningFixtures.aeroplane();
        Speeds speeds = usual.speeds().withCruise(random.nextDouble(8, 14));
        Craft craft = PlanningFixtures.craft(number, anywhere(), anywhere())
                .with(new Performance(speeds, usual.power(), usual.response()));
        if (random.nextBoolean()) {
            craft = craft.with(EnergyBudget.ofWattHours(random.nextDouble(5, 40), 2));
        }
        return random.nextInt(3) == 0
                ? craft.with(Start.inFlight(PlanningFixtures.place(anywhere(), anywhere(), 450)))
                : craft;
    }
}
