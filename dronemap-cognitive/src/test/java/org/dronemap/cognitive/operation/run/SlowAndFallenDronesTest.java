package org.dronemap.cognitive.operation.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dronemap.cognitive.operation.run.MissionRunOperationTest.changed;
import static org.dronemap.cognitive.operation.run.MissionRunOperationTest.fleet;
import static org.dronemap.cognitive.operation.run.MissionRunOperationTest.triggers;

import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.junit.jupiter.api.Test;

/** Drones of a run that rise slowly, fall, or take off while others fly. */
class SlowAndFallenDronesTest {
    @Test
    void givesNobodyUpWhoIsSlowToRise() {
        RunTestBench fleet = fleet(3, 30);
        fleet.vehicles.values().forEach(vehicle -> vehicle.lingers = 12);

        fleet.flyToTheEnd();
        assertThat(triggers(fleet)).doesNotContain(RunTrigger.CRASHED);
        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(30);
    }

    @Test
    void givesTheWaypointsOfAFallenDroneToOthersWithinFiveSeconds() {
        RunTestBench fleet = fleet(3, 30);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);

        fleet.vehicle(1).falling = true;
        fleet.flyUntil(() -> fleet.drone(1).stage() == RunDroneStage.CRASHED, 2);
        fleet.flyUntil(() -> fleet.state.counts().replans() > 0 && changed(fleet), 3);

        fleet.flyToTheEnd();
        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(30);
        assertThat(fleet.drone(1).stage()).isEqualTo(RunDroneStage.CRASHED);
    }

    @Test
    void givesThemToThoseThatAreUpAsLongAsAnotherTakesOff() {
        RunTestBench fleet = fleet(4, 40);
        fleet.vehicle(0).lingers = 40;
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 2, 60);

        fleet.vehicle(1).falling = true;
        fleet.flyUntil(() -> fleet.drone(1).stage() == RunDroneStage.CRASHED, 2);
        fleet.flyUntil(
                () -> fleet.state.counts().replans() > 0
                        && fleet.state.drones().stream().allMatch(drone -> drone.next() == null),
                3);
        assertThat(CraftSnapshots.isTakingOff(fleet.drone(0))).isTrue();
    }
}
