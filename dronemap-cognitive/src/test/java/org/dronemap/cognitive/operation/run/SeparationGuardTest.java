package org.dronemap.cognitive.operation.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Objects;
import java.util.Set;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.command.SetReturnHeight;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.zone.AltitudeBand;
import org.junit.jupiter.api.Test;

/** Drones that would come too near to each other. */
class SeparationGuardTest {
    private static final double UP = TestVehicle.GROUND + 40;

    private static RunTestBench flying() {
        RunTestBench fleet = RunFixtures.fleet(3, 30, 1, MissionCloudLossPolicy.CONTINUE);
        // All fly home at one height.
        fleet.loses = give -> give.command() instanceof SetReturnHeight;
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
        return fleet;
    }

    /** It stays in the air where it is, and another one flies home by itself straight through that place. */
    private static TestVehicle comesAtOneThatStands(RunTestBench fleet) {
        TestVehicle stands = fleet.vehicle(1);
        stands.east = 150;
        stands.north = 0;
        stands.altitude = UP;
        stands.mode = "BRAKE";
        fleet.vehicle(2).east = -300;
        fleet.vehicle(2).north = -300;
        TestVehicle comes = fleet.vehicle(0);
        comes.east = 250;
        comes.north = 0;
        comes.altitude = UP;
        comes.mode = "RTL";
        fleet.closest = Double.POSITIVE_INFINITY;
        return stands;
    }

    private static RunTestBench withOneThatIsHeld() {
        RunTestBench fleet = flying();
        fleet.wish(new RunInput.ResumeDrone(fleet.now, "Ann", suspended(fleet).id));
        comesAtOneThatStands(fleet);
        return fleet;
    }

    private static TestVehicle suspended(RunTestBench fleet) {
        TestVehicle vehicle = fleet.vehicle(1);
        vehicle.mode = "LOITER";
        fleet.fly(5);
        assertThat(fleet.drone(1).stage()).isEqualTo(RunDroneStage.SUSPENDED);
        return vehicle;
    }

    @Test
    void getTheirNewMissionWhileTheyMakeRoomAndBeginItAfterwards() {
        RunTestBench fleet = flying();
        TestVehicle aside = fleet.makesRoom(1, 0, "GUIDED", 10);

        fleet.vehicle(2).falling = true;
        fleet.flyUntil(() -> fleet.drone(1).next() != null, 3);
        fleet.flyUntil(() -> fleet.drone(1).next() == null, 3);
        assertThat(fleet.drone(1).stage()).isEqualTo(RunDroneStage.HOLDING);
        assertThat(aside.mode).isEqualTo("GUIDED");
        fleet.flyUntil(aside::fliesMission, 15);
    }

    @Test
    void makeRoomForOneThatFliesHomeByItself() {
        RunTestBench fleet = withOneThatIsHeld();
        fleet.fly(12);

        assertThat(fleet.said).anyMatch(said -> said.contains("to make room for Drone d0"));
        assertThat(fleet.closest).as("%s; %s", fleet.where, fleet.said).isGreaterThanOrEqualTo(10);
        fleet.flyToTheEnd();
        assertThat(fleet.state.count(RunWaypoint.State.VISITED))
                .as("%s", fleet.said)
                .isEqualTo(30);
    }

    @Test
    void doNotLeaveAFenceToMakeRoom() {
        RunTestBench fleet = withOneThatIsHeld();
        fleet.wish(new RunInput.AddBarrier(
                fleet.now,
                "Ann",
                new Barrier(
                        "the flight area “Low”",
                        new FenceArea.Circle(true, PlanningFixtures.point(0, 0), 1_000),
                        new AltitudeBand(
                                TestVehicle.GROUND - 10, UP + 0.5, org.dronemap.core.mission.Altitude.Reference.AMSL),
                        Set.of())));
        for (int i = 0; i < 48; i++) {
            fleet.fly(0.25);
            assertThat(fleet.vehicle(1).altitude).isLessThanOrEqualTo(UP + 0.5);
        }
        assertThat(fleet.said).anyMatch(said -> said.contains("to make room for Drone d0"));
    }

    @Test
    void stopOneOfTwoWhoseWaysHomeCross() {
        RunTestBench fleet = flying();
        flies(fleet.vehicle(0), 200, 200, "RTL");
        flies(fleet.vehicle(1), -160, 200, "RTL");
        flies(fleet.vehicle(2), -300, -300, "AUTO");
        fleet.closest = Double.POSITIVE_INFINITY;
        fleet.fly(40);

        assertThat(fleet.closest).as("%s; %s", fleet.where, fleet.said).isGreaterThanOrEqualTo(10);
        assertThat(fleet.said).anyMatch(said -> said.contains("waits until Drone d"));
        fleet.flyToTheEnd();
        assertThat(fleet.vehicles.values()).noneMatch(TestVehicle::isUp);
    }

    private static void flies(TestVehicle vehicle, double east, double north, String mode) {
        vehicle.east = east;
        vehicle.north = north;
        vehicle.altitude = UP;
        vehicle.mode = mode;
    }

    @Test
    void doNotTakeOffBelowOneThatIsInTheWay() {
        RunTestBench fleet = RunFixtures.fleet(3, 12, 1, MissionCloudLossPolicy.CONTINUE);
        fleet.flyUntil(
                () -> fleet.state.drones().stream().anyMatch(drone -> drone.stage() == RunDroneStage.LANDED), 1_000);
        int down = fleet.drone(0).stage() == RunDroneStage.LANDED
                ? 0
                : fleet.drone(1).stage() == RunDroneStage.LANDED ? 1 : 2;
        int other = (down + 1) % 3;
        TestVehicle above = fleet.vehicle(other);
        above.mode = "LOITER";
        above.east = fleet.vehicle(down).homeEast + 3;
        above.north = 0;
        above.altitude = TestVehicle.GROUND + 20;
        fleet.wish(new RunInput.GiveUpDrone(fleet.now, "Ann", fleet.vehicle(3 - down - other).id));
        fleet.wish(new RunInput.AddWaypoints(
                fleet.now, "Ann", List.of(Waypoint.at("n1", PlanningFixtures.place(0, 300, 440)))));
        fleet.fly(40);

        assertThat(fleet.drone(down).stage()).as("%s", fleet.said).isEqualTo(RunDroneStage.READY);
        assertThat(fleet.vehicle(down).armed).isFalse();
        assertThat(fleet.said).anyMatch(said -> said.contains("waits on the ground until Drone d" + other));
        above.mode = "RTL";
        fleet.flyToTheEnd();
        assertThat(fleet.visits).containsKey("n1");
    }

    private static Place headsFor(RunDrone drone) {
        return MissionLegs.ahead(Objects.requireNonNull(drone.sortie()), drone.passed())
                .get(0);
    }

    /** They came nearer than plans have it, by wind or since one stood: stopping either would keep them there. */
    @Test
    void letTwoGoOnThatLeaveEachOther() {
        RunTestBench fleet = flying();
        Place there = headsFor(fleet.drone(0));
        Place elsewhere = headsFor(fleet.drone(1));
        LocalPlane plane = new LocalPlane(PlanningFixtures.point(0, 0));
        PlanePoint one = plane.spot(there.point());
        PlanePoint other = plane.spot(elsewhere.point());
        double east = (one.eastMeters() + other.eastMeters()) / 2;
        double north = (one.northMeters() + other.northMeters()) / 2;
        double share = 3.1 / Math.hypot(one.eastMeters() - east, one.northMeters() - north);
        flies(
                fleet.vehicle(0),
                east + share * (one.eastMeters() - east),
                north + share * (one.northMeters() - north),
                "AUTO");
        flies(
                fleet.vehicle(1),
                east - share * (one.eastMeters() - east),
                north - share * (one.northMeters() - north),
                "AUTO");
        flies(fleet.vehicle(2), -400, -400, "AUTO");
        int said = fleet.said.size();
        fleet.fly(3);

        assertThat(fleet.said.subList(said, fleet.said.size())).noneMatch(words -> words.contains("waits until"));
        assertThat(fleet.vehicle(0).mode).isEqualTo("AUTO");
        assertThat(fleet.vehicle(1).mode).isEqualTo("AUTO");
    }
}
