package org.dronemap.cognitive.operation.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Comparator;
import java.util.List;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.mission.MissionItem;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A battery gives in, near the reserve that is to be left at home, above and below. */
class LowBatteryTest {
    @ParameterizedTest
    @ValueSource(doubles = {0.15, 0.17, 0.18, 0.19, 0.2, 0.21, 0.22, 0.24, 0.26, 0.3})
    void whatItLeavesIsOnBoardOfOthersAtOnceAndItComesHome(double share) {
        RunTestBench fleet = RunFixtures.limited(3, 30, 1);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
        TestVehicle weak = fleet.vehicle(1);

        weak.joules = share * weak.fullJoules;
        int replans = fleet.state.counts().replans();
        fleet.flyUntil(() -> fleet.state.counts().replans() > replans, 3);
        fleet.flyUntil(
                () -> fleet.state.drones().stream()
                        .filter(drone -> !drone.id().equals(weak.id))
                        .allMatch(drone -> drone.next() == null),
                5);

        assertThat(fleet.said).noneMatch(words -> words.contains("There is no plan"));
        fleet.flyToTheEnd();
        assertThat(weak.joules).as("%s", fleet.said).isPositive();
        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(30);
        assertThat(fleet.closest).as("%s; %s", fleet.where, fleet.said).isGreaterThanOrEqualTo(10);
    }

    @Test
    void evenWhatItFliesToIsTakenFromItAtOnce() {
        RunTestBench fleet = RunFixtures.limited(3, 30, 4);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
        TestVehicle weak = fleet.vehicle(1);

        weak.joules = 0.2 * weak.fullJoules;
        fleet.flyUntil(() -> fleet.said.stream().anyMatch(words -> words.contains("does not last")), 60);
        fleet.flyUntil(() -> fleet.state.counts().replans() > 0, 1);

        fleet.flyToTheEnd();
        assertThat(weak.joules).isPositive();
        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(30);
    }

    @Test
    void itIsTakenAlsoFromOneThatWaitsForAnotherToPass() {
        RunTestBench fleet = RunFixtures.limited(3, 30, 1);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
        TestVehicle weak = fleet.makesRoom(1, 0, "BRAKE", 30);

        weak.joules = 0.3 * weak.fullJoules;
        fleet.flyUntil(() -> fleet.said.stream().anyMatch(words -> words.contains("does not last")), 2);
        fleet.flyUntil(() -> fleet.state.counts().replans() > 0, 1);
        assertThat(fleet.drone(1).stage()).isIn(RunDroneStage.HOLDING, RunDroneStage.REPLACING);
    }

    /** Who is about to be up gets it, not who climbs for a while yet. */
    @Test
    void whatItLeavesGoesToThoseThatWillBeUpFirst() {
        RunTestBench fleet = RunFixtures.limited(3, 30, 1);
        fleet.flyUntil(() -> fleet.vehicles.values().stream().allMatch(TestVehicle::isUp), 30);
        List<TestVehicle> byHeight = fleet.vehicles.values().stream()
                .sorted(Comparator.comparingDouble(LowBatteryTest::metersToGo))
                .toList();
        TestVehicle weak = byHeight.get(0);
        TestVehicle soonUp = byHeight.get(1);
        DroneId higher = byHeight.get(2).id;
        fleet.flyUntil(() -> metersToGo(soonUp) < 1.5, 30);
        assertThat(metersToGo(byHeight.get(2))).isGreaterThan(4);
        List<String> had = fleet.state.drone(higher).orElseThrow().orders();

        weak.joules = 0.22 * weak.fullJoules;
        fleet.flyUntil(() -> fleet.state.counts().replans() > 0, 2);
        assertThat(fleet.said)
                .anyMatch(words -> words.contains(
                        "from " + fleet.state.drone(weak.id).orElseThrow().name()));
        assertThat(fleet.state.drone(higher).orElseThrow().orders()).isEqualTo(had);
    }

    private static double metersToGo(TestVehicle vehicle) {
        MissionItem.TakeOff takeOff = (MissionItem.TakeOff) vehicle.items.get(0);
        return TestVehicle.GROUND + takeOff.altitudeMeters() - vehicle.altitude;
    }
}
