package org.dronemap.cognitive.operation.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunOrder;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.EnergyBudget;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.drone.DroneId;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Six drones and 120 waypoints in virtual time: a motor fails, a link breaks, a battery gives in, ten waypoints come, the server dies. */
class LargeRunTest {
    private static final double FULL_JOULES = 400_000;

    private static RunTestBench fleet(long seed) {
        PlanningProblem problem = RunFixtures.problem(6, 120, seed, false);
        List<Craft> crafts = problem.crafts().stream()
                .map(craft -> craft.with(new EnergyBudget(FULL_JOULES, 0.2 * FULL_JOULES)))
                .toList();
        return RunFixtures.fleet(
                PlanningProblem.of(problem.waypoints(), crafts),
                seed,
                RunOrder.ApprovalMode.AUTOMATIC,
                MissionCloudLossPolicy.RETURN_TO_LAUNCH);
    }

    /** Seconds from now until all that get something of what that drone leaves have acknowledged their missions. */
    private static double untilOnBoard(RunTestBench fleet, DroneId lost, int longest) {
        Instant from = fleet.now;
        int replans = fleet.state.counts().replans();
        fleet.flyUntil(
                () -> fleet.state.counts().replans() > replans
                        && fleet.state.drones().stream()
                                .filter(drone -> !drone.id().equals(lost))
                                .allMatch(drone -> drone.next() == null),
                longest);
        return Duration.between(from, fleet.now).toMillis() / 1_000.0;
    }

    private static List<Waypoint> ten(SplittableRandom random) {
        List<Waypoint> ten = new ArrayList<>();
        for (int i = 0; i < 10; i++) {
            ten.add(Waypoint.at(
                    "new" + i,
                    PlanningFixtures.place(random.nextDouble(-450, 450), random.nextDouble(-450, 450), 440)));
        }
        return ten;
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void visitsEveryWaypointWithThoseThatAreLeft(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        RunTestBench fleet = fleet(seed);
        fleet.fly(40 + random.nextInt(40));

        fleet.vehicle(1).falling = true;
        assertThat(untilOnBoard(fleet, fleet.vehicle(1).id, 30))
                .as("motor; %s", fleet.said)
                .isLessThanOrEqualTo(5);
        fleet.fly(10 + random.nextInt(30));
        fleet.vehicle(2).cut = true;
        assertThat(untilOnBoard(fleet, fleet.vehicle(2).id, 30))
                .as("link; %s", fleet.said)
                .isLessThanOrEqualTo(8);
        fleet.fly(10 + random.nextInt(30));
        fleet.wish(new RunInput.AddWaypoints(fleet.now, "Ann", ten(random)));
        fleet.fly(20);
        fleet.vehicle(3).joules = 0.14 * FULL_JOULES;
        assertThat(untilOnBoard(fleet, fleet.vehicle(3).id, 30))
                .as("battery; %s", fleet.said)
                .isLessThanOrEqualTo(5);
        fleet.fly(10 + random.nextInt(30));
        fleet.restart(4);
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED))
                .as("%s", fleet.said)
                .isEqualTo(130);
        assertThat(fleet.visits.keySet()).hasSize(130);
        assertThat(fleet.closest).as("%s; %s", fleet.where, fleet.said).isGreaterThanOrEqualTo(10);
        assertThat(fleet.vehicle(3).joules).isPositive();
        fleet.visits.values().stream()
                .filter(by -> by.stream().distinct().count() > 1)
                .forEach(by -> assertThat(by).contains(fleet.vehicle(2).id));
    }
}
