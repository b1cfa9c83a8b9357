package org.dronemap.cognitive.operation.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunOrder;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.command.SetReturnHeight;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.zone.AltitudeBand;
import org.junit.jupiter.api.Test;

/** Drones of a run fly home in layers, and are left as they were found. */
class ReturnHeightOverrideTest {
    private static RunTestBench up(RunTestBench fleet) {
        fleet.flyUntil(() -> fleet.vehicles.values().stream().allMatch(TestVehicle::isUp), 120);
        return fleet;
    }

    private static List<Double> heights(RunTestBench fleet) {
        return fleet.vehicles.values().stream()
                .map(vehicle -> vehicle.returnMeters)
                .sorted()
                .toList();
    }

    @Test
    void eachHasALayerOfItsOwnAboveAllThatIsFlown() {
        RunTestBench fleet = up(RunFixtures.fleet(4, 16, 1));

        List<Double> heights = heights(fleet);
        double highest = fleet.state.targets().stream()
                .mapToDouble(target -> target.waypoint().place().altitudeAmslMeters() - TestVehicle.GROUND)
                .max()
                .orElseThrow();
        assertThat(heights.get(0)).isGreaterThanOrEqualTo(highest + 5);
        for (int i = 1; i < heights.size(); i++) {
            assertThat(heights.get(i) - heights.get(i - 1)).isGreaterThanOrEqualTo(5);
        }
    }

    @Test
    void areSetBackWhenTheRunIsOver() {
        RunTestBench fleet = up(RunFixtures.fleet(3, 12, 1));
        fleet.vehicle(1).mode = "RTL";

        fleet.flyToTheEnd();

        assertThat(heights(fleet)).containsOnly(15.0);
        assertThat(fleet.state.end()).doesNotContain("flies home");
    }

    @Test
    void areSetBackWhenTheRunIsStoppedThoughAnAnswerIsLost() {
        RunTestBench fleet = up(RunFixtures.fleet(3, 12, 1));
        List<Object> lost = new ArrayList<>();
        fleet.loses = give -> give.command() instanceof SetReturnHeight && lost.size() < 2 && lost.add(give);
        fleet.wish(new RunInput.Stop(fleet.now, "Ann"));

        fleet.flyToTheEnd();

        assertThat(lost).hasSize(2);
        assertThat(heights(fleet)).containsOnly(15.0);
    }

    @Test
    void areSetBackAfterARestart() {
        RunTestBench fleet = up(RunFixtures.fleet(3, 12, 1, MissionCloudLossPolicy.CONTINUE));
        fleet.restart(3);

        fleet.flyToTheEnd();

        assertThat(heights(fleet)).containsOnly(15.0);
    }

    @Test
    void areNeverLoweredSinceThereMayBeSomethingToFlyOver() {
        RunTestBench fleet = RunFixtures.fleet(3, 12, 1);
        fleet.vehicle(1).returnMeters = 140;
        up(fleet);
        assertThat(fleet.vehicle(1).returnMeters).isEqualTo(140);

        fleet.flyToTheEnd();

        assertThat(fleet.vehicle(1).returnMeters).isEqualTo(140);
    }

    @Test
    void fliesAllTheSameWhereItCannotBeSetAndSaysSo() {
        RunTestBench fleet = RunFixtures.fleet(3, 12, 1);
        fleet.loses = give -> give.command() instanceof SetReturnHeight
                && give.drone().value().equals("d1");

        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(12);
        assertThat(fleet.said).anyMatch(said -> said.contains("Drone d1 could not be told how high to fly home"));
        assertThat(fleet.vehicle(1).visits).isNotEmpty();
    }

    @Test
    void saysAtTheEndWhatCouldNotBePutBack() {
        RunTestBench fleet = up(RunFixtures.fleet(3, 12, 1));
        double height = fleet.vehicle(1).returnMeters;
        fleet.vehicle(1).cut = true;

        fleet.flyToTheEnd();

        assertThat(fleet.state.end())
                .contains("Drone d1 still flies home at " + Math.round(height) + " m; 15 m was set before.");
    }

    @Test
    void oneThatJoinsGetsALayerOverTheOthers() {
        RunTestBench fleet = up(RunFixtures.fleet(3, 12, 1));
        double highest = heights(fleet).get(2);
        TestVehicle another = new TestVehicle(7, 300, 0);
        fleet.vehicles.put(another.id, another);
        fleet.wish(new RunInput.JoinDrone(
                fleet.now, "Ann", PlanningFixtures.craft(7, 300, 0), "Drone d7", VehicleKind.MULTICOPTER));

        Double layer = fleet.drone(7).profile().returnMeters();

        assertThat(layer).isNotNull().isGreaterThanOrEqualTo(highest + 5);
    }

    @Test
    void layersStayBelowCeilingsAndAreSharedWhereThereAreTooFew() {
        PlanningProblem problem = RunFixtures.problem(4, 12, 1, false);
        Barrier ceiling = new Barrier(
                "the zone “Field”",
                new FenceArea.Circle(true, PlanningFixtures.point(0, 0), 2_000),
                new AltitudeBand(null, 460.0, Altitude.Reference.AMSL),
                Set.of());
        PlanningProblem below = new PlanningProblem(
                problem.waypoints(),
                problem.crafts(),
                List.of(ceiling),
                problem.wind(),
                problem.objective(),
                problem.rules());
        RunTestBench fleet =
                up(RunFixtures.fleet(below, 1, RunOrder.ApprovalMode.AUTOMATIC, MissionCloudLossPolicy.CONTINUE));

        assertThat(heights(fleet)).allMatch(meters -> TestVehicle.GROUND + meters <= 460);
        assertThat(Set.copyOf(heights(fleet))).hasSizeGreaterThan(1).hasSizeLessThan(4);
    }
}
