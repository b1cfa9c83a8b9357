package org.dronemap.cognitive.operation.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.junit.jupiter.api.Test;

/** A pilot took a drone and lets it hover: nobody can move it, and nobody waits for it to pass. */
class DroneObstaclesTest {
    private static RunTestBench withOneThatHoversBesideAWaypoint() {
        RunTestBench fleet = RunFixtures.fleet(3, 18, 1, MissionCloudLossPolicy.RETURN_TO_LAUNCH);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
        TestVehicle hovers = fleet.vehicle(1);
        hovers.mode = "LOITER";
        fleet.fly(10);
        Waypoint beside = Waypoint.at("beside", PlanningFixtures.place(hovers.east + 4, hovers.north, hovers.altitude));
        fleet.wish(new RunInput.AddWaypoints(fleet.now, "Ann", List.of(beside)));
        return fleet;
    }

    @Test
    void othersFlyRoundItAndSayWhyTheyLeaveOutWhatLiesThere() {
        RunTestBench fleet = withOneThatHoversBesideAWaypoint();
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) == 18, 900);
        fleet.fly(120);

        RunWaypoint beside = fleet.state.target("beside").orElseThrow();
        assertThat(beside.reason())
                .isEqualTo("It lies where Drone d1, which stands in the air there, keeps drones from.");
        assertThat(fleet.closest).as("%s; %s", fleet.where, fleet.said).isGreaterThanOrEqualTo(10);
    }

    @Test
    void whatItStoodBesideIsServedWhenItIsGone() {
        RunTestBench fleet = withOneThatHoversBesideAWaypoint();
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) == 18, 900);
        fleet.vehicle(1).mode = "RTL";
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED))
                .as("%s", fleet.said)
                .isEqualTo(19);
        assertThat(fleet.closest).as("%s; %s", fleet.where, fleet.said).isGreaterThanOrEqualTo(10);
    }
}
