package org.dronemap.cognitive.operation.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Objects;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.junit.jupiter.api.Test;

/** Drones to which something happens just as they come to a waypoint. */
class WaypointArrivalTest {
    private static RunTestBench flying() {
        RunTestBench fleet = RunFixtures.fleet(3, 30, 1);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
        return fleet;
    }

    /** On its way to the first waypoint that it has, so many metres before it. */
    private static void isBefore(RunTestBench fleet, TestVehicle vehicle, double meters) {
        RunDrone drone = fleet.state.drone(vehicle.id).orElseThrow();
        Place place = MissionLegs.ahead(Objects.requireNonNull(drone.sortie()), drone.passed())
                .get(0);
        PlanePoint there = new LocalPlane(PlanningFixtures.point(0, 0)).spot(place.point());
        double east = vehicle.east - there.eastMeters();
        double north = vehicle.north - there.northMeters();
        double share = meters / Math.hypot(east, north);
        vehicle.east = there.eastMeters() + share * east;
        vehicle.north = there.northMeters() + share * north;
        vehicle.altitude = place.altitudeAmslMeters();
    }

    @Test
    void reachIt() {
        RunTestBench fleet = flying();
        TestVehicle comes = fleet.vehicle(0);
        fleet.vehicle(1).falling = true;
        fleet.flyUntil(() -> fleet.drone(1).stage() == RunDroneStage.CRASHED, 2);
        comes.cruise = 1;
        isBefore(fleet, comes, 3.5);
        int visits = comes.visits.size();

        fleet.flyUntil(() -> fleet.drone(0).next() != null, 2);
        fleet.flyUntil(() -> !comes.fliesMission(), 8);
        assertThat(comes.visits).as("%s", fleet.said).hasSize(visits + 1);

        comes.cruise = 10;
        fleet.flyToTheEnd();
        assertThat(fleet.state.count(RunWaypoint.State.VISITED))
                .as("%s", fleet.said)
                .isEqualTo(30);
    }

    /** Nothing is gained by waiting for one that comes to nothing. */
    @Test
    void areNotWaitedForWhereTheyStand() {
        RunTestBench fleet = flying();
        TestVehicle stands = fleet.vehicle(0);
        stands.cruise = 0;
        isBefore(fleet, stands, 3);
        fleet.fly(1.5);
        fleet.vehicle(1).falling = true;

        fleet.flyUntil(() -> fleet.drone(1).stage() == RunDroneStage.CRASHED, 2);
        fleet.flyUntil(() -> !stands.fliesMission(), 3);
    }

    /** They may have been seen there: it would be a second visit that another order of waypoints saves a few metres by. */
    @Test
    void beginWithItWhereTheyWereStoppedShortOfIt() {
        RunTestBench fleet = flying();
        TestVehicle stopped = fleet.vehicle(1);
        isBefore(fleet, stopped, 6);
        fleet.makesRoom(1, 0, "GUIDED", 10);
        String first = fleet.drone(1).orders().get(0);

        Waypoint here = Waypoint.at("n1", PlanningFixtures.place(stopped.east, stopped.north, stopped.altitude));
        fleet.wish(new RunInput.AddWaypoints(fleet.now, "Ann", List.of(here)));
        fleet.flyUntil(() -> fleet.drone(1).next() != null, 5);
        assertThat(fleet.drone(1).orders()).startsWith(first, "n1");
    }

    @Test
    void areNotCalledHomeFromItsLastMetres() {
        RunTestBench fleet = RunFixtures.limited(3, 30, 1);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
        TestVehicle weak = fleet.vehicle(1);
        weak.cruise = 1;
        isBefore(fleet, weak, 3);
        int visits = weak.visits.size();

        weak.joules = 0.2 * weak.fullJoules;
        fleet.flyUntil(() -> fleet.drone(1).stage() == RunDroneStage.RETURNING, 5);
        assertThat(weak.visits).as("%s", fleet.said).hasSize(visits + 1);
        assertThat(fleet.said).anyMatch(words -> words.contains("lasts for its way home at most"));
        fleet.flyToTheEnd();
        assertThat(fleet.state.count(RunWaypoint.State.VISITED))
                .as("%s", fleet.said)
                .isEqualTo(30);
    }

    @Test
    void areCalledHomeWhereTheWayToTheNextIsShort() {
        RunTestBench fleet = RunFixtures.limited(3, 30, 1);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
        TestVehicle weak = fleet.vehicle(1);
        weak.cruise = 1;
        isBefore(fleet, weak, 15);

        weak.joules = 0.2 * weak.fullJoules;
        fleet.flyUntil(() -> fleet.drone(1).stage() == RunDroneStage.RETURNING, 1);
    }

    /** The vehicle's own word for it comes all the same. */
    @Test
    void doNotCountAsThereWhenTheyTumbleThroughIt() {
        RunTestBench fleet = flying();
        TestVehicle drops = fleet.vehicle(1);
        String first = fleet.drone(1).orders().get(0);
        int visits = drops.visits.size();
        drops.tumbles = true;
        fleet.flyUntil(() -> drops.visits.size() > visits, 60);
        drops.tumbles = false;
        drops.falling = true;
        fleet.flyUntil(() -> fleet.drone(1).stage() == RunDroneStage.CRASHED, 2);
        assertThat(fleet.state.target(first).orElseThrow().visits()).isEmpty();

        fleet.flyToTheEnd();
        assertThat(fleet.state.count(RunWaypoint.State.VISITED))
                .as("%s", fleet.said)
                .isEqualTo(30);
    }
}
