package org.dronemap.cognitive.operation.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronemap.cognitive.Scenes;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.command.CloudLoss;
import org.junit.jupiter.api.Test;

/** A pilot took a drone and lets it hover: nobody can move it, and nobody waits for it to pass. */
class ObstaclesTest {
    private static TestFleet withOneThatHoversBesideAWaypoint() {
        TestFleet fleet = Runs.fleet(3, 18, 1, CloudLoss.RETURN_TO_LAUNCH);
        fleet.flyUntil(() -> fleet.state.count(Target.State.VISITED) >= 3, 600);
        TestVehicle hovers = fleet.vehicle(1);
        hovers.mode = "LOITER";
        fleet.fly(10);
        Waypoint beside = Waypoint.at("beside", Scenes.place(hovers.east + 4, hovers.north, hovers.altitude));
        fleet.wish(new RunInput.AddWaypoints(fleet.now, "Ann", List.of(beside)));
        return fleet;
    }

    @Test
    void othersFlyRoundItAndSayWhyTheyLeaveOutWhatLiesThere() {
        TestFleet fleet = withOneThatHoversBesideAWaypoint();
        fleet.flyUntil(() -> fleet.state.count(Target.State.VISITED) == 18, 900);
        fleet.fly(120);

        Target beside = fleet.state.target("beside").orElseThrow();
        assertThat(beside.reason())
                .isEqualTo("It lies where Drone d1, which stands in the air there, keeps drones from.");
        assertThat(fleet.closest).as("%s; %s", fleet.where, fleet.said).isGreaterThanOrEqualTo(10);
    }

    @Test
    void whatItStoodBesideIsServedWhenItIsGone() {
        TestFleet fleet = withOneThatHoversBesideAWaypoint();
        fleet.flyUntil(() -> fleet.state.count(Target.State.VISITED) == 18, 900);
        fleet.vehicle(1).mode = "RTL";
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(Target.State.VISITED)).as("%s", fleet.said).isEqualTo(19);
        assertThat(fleet.closest).as("%s; %s", fleet.where, fleet.said).isGreaterThanOrEqualTo(10);
    }
}
