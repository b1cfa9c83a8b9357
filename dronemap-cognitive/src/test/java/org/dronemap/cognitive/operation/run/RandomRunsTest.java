package org.dronemap.cognitive.operation.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunOrder;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Whatever befalls a run at whatever moment: no waypoint is two drones', nobody comes near to anybody, and all is settled in the end. */
class RandomRunsTest {
    @ParameterizedTest
    @ValueSource(longs = {1, 4, 8, 13, 26, 40, 49, 54, 59, 92, 94, 175, 214, 237, 318, 340})
    void settleAllWaypoints(long seed) {
        RunTestBench fleet = disturbed(seed);
        fleet.flyToTheEnd();
        assertThat(fleet.closest).as("%s; %s", fleet.where, fleet.said).isGreaterThanOrEqualTo(10);
        boolean somebodyLeft = fleet.state.drones().stream().anyMatch(drone -> drone.stage() == RunDroneStage.LANDED);
        if (somebodyLeft) {
            assertThat(fleet.state.count(RunWaypoint.State.UNSERVED))
                    .as("%s", fleet.said)
                    .isZero();
        }
    }

    static RunTestBench disturbed(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        RunTestBench fleet = undisturbed(random, seed);
        fleet.loses = give -> random.nextInt(20) == 0;
        int events = 2 + random.nextInt(4);
        for (int i = 0; i < events && !fleet.state.isOver(); i++) {
            fleet.fly(random.nextInt(5, 80));
            disturb(fleet, random, i);
        }
        fleet.vehicles.values().forEach(vehicle -> vehicle.takenBy = null);
        return fleet;
    }

    static RunTestBench undisturbed(SplittableRandom random, long seed) {
        MissionCloudLossPolicy loss =
                random.nextBoolean() ? MissionCloudLossPolicy.CONTINUE : MissionCloudLossPolicy.RETURN_TO_LAUNCH;
        return RunFixtures.fleet(
                RunFixtures.problem(4 + random.nextInt(3), 40, seed, false),
                seed,
                RunOrder.ApprovalMode.AUTOMATIC,
                loss);
    }

    private static void disturb(RunTestBench fleet, SplittableRandom random, int number) {
        List<TestVehicle> all = new ArrayList<>(fleet.vehicles.values());
        TestVehicle vehicle = all.get(random.nextInt(all.size() - 1));
        switch (random.nextInt(7)) {
            case 0 -> vehicle.falling = vehicle.isUp();
            case 1 -> vehicle.cut = true;
            case 2 -> {
                vehicle.cut = true;
                fleet.fly(random.nextInt(2, 60));
                vehicle.cut = false;
            }
            case 3 -> vehicle.mode = vehicle.isUp() ? "RTL" : vehicle.mode;
            case 4 -> {
                if (!fleet.state.isOver()) {
                    fleet.wish(new RunInput.AddWaypoints(
                            fleet.now,
                            "Ann",
                            List.of(Waypoint.at(
                                    "n" + number,
                                    PlanningFixtures.place(
                                            random.nextDouble(-400, 400), random.nextDouble(-400, 400), 441)))));
                }
            }
            case 5 -> fleet.restart(random.nextInt(1, 8));
            default -> {
                if (vehicle.isUp()) {
                    vehicle.mode = "LOITER";
                    fleet.fly(random.nextInt(1, 30));
                    vehicle.mode = "RTL";
                }
            }
        }
    }
}
