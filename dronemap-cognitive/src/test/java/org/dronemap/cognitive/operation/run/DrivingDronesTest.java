package org.dronemap.cognitive.operation.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.mission.MissionItem;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Drones that drive are never in the air: what is done, held and called home is judged by what they do instead. */
class DrivingDronesTest {
    private static RunTestBench rover(int waypoints) {
        return RunFixtures.mixed(5, waypoints, VehicleKind.ROVER);
    }

    private static void drivesPast(RunTestBench fleet, int waypoints) {
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= waypoints, 900);
    }

    private static boolean isHome(TestVehicle vehicle) {
        return Math.hypot(vehicle.east - vehicle.homeEast, vehicle.north - vehicle.homeNorth) < 2;
    }

    private static List<MissionItem.Waypoint> visitedTwice(TestVehicle vehicle) {
        List<MissionItem.Waypoint> twice = new ArrayList<>(vehicle.visits);
        vehicle.visits.stream().distinct().forEach(twice::remove);
        return twice;
    }

    @ParameterizedTest
    @ValueSource(strings = {"AUTO", "HOLD", "LOITER"})
    void isDoneWhenItIsHomeWithItsMissionComplete(String modeAtTheEnd) {
        RunTestBench fleet = rover(4);
        fleet.flyUntil(() -> fleet.vehicle(0).complete, 900);
        fleet.vehicle(0).mode = modeAtTheEnd;
        fleet.fly(5);

        assertThat(fleet.state.isOver()).as("%s", fleet.said).isTrue();
        assertThat(fleet.drone(0).stage()).isEqualTo(RunDroneStage.LANDED);
        assertThat(fleet.vehicle(0).armed).isFalse();
        assertThat(fleet.state.end()).contains("all 4 waypoints visited");
        assertThat(fleet.said).noneMatch(words -> words.contains("does not move on"));
    }

    /** As rovers do that stop a moment before they say that their mission is complete. */
    @Test
    void isDoneWhenItHoldsAtHomeBeforeItSaysThatItsMissionIsComplete() {
        RunTestBench fleet = rover(4);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) == 4 && isHome(fleet.vehicle(0)), 900);
        fleet.vehicle(0).mode = "HOLD";
        fleet.fly(5);

        assertThat(fleet.drone(0).stage()).as("%s", fleet.said).isEqualTo(RunDroneStage.LANDED);
    }

    /** Its motors keep it where it is. */
    @Test
    void aBoatThatIsDoneStaysArmed() {
        RunTestBench fleet = RunFixtures.mixed(5, 4, VehicleKind.BOAT);
        fleet.flyToTheEnd();

        assertThat(fleet.drone(0).stage()).isEqualTo(RunDroneStage.LANDED);
        assertThat(fleet.vehicle(0).armed).isTrue();
        assertThat(fleet.state.end()).contains("Drone d0 holds its place at home, armed");
    }

    @Test
    void goesOnAfterAPauseWhereItWasAndDoesNothingTwice() {
        RunTestBench fleet = rover(8);
        drivesPast(fleet, 3);
        fleet.wish(new RunInput.Pause(fleet.now, "Ann"));
        fleet.fly(60);
        assertThat(fleet.vehicle(0).mode).isEqualTo("HOLD");
        fleet.wish(new RunInput.Resume(fleet.now, "Ann"));
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(8);
        assertThat(visitedTwice(fleet.vehicle(0))).isEmpty();
    }

    @Test
    void getsANewPlanOnItsWay() {
        RunTestBench fleet = RunFixtures.mixed(7, 10, VehicleKind.ROVER, VehicleKind.MULTICOPTER);
        drivesPast(fleet, 2);
        RunFixtures.addTwoWaypoints(fleet);
        fleet.wish(new RunInput.Pause(fleet.now, "Ann"));
        fleet.fly(30);
        fleet.wish(new RunInput.Resume(fleet.now, "Ann"));
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(12);
        assertThat(fleet.state.drones()).allMatch(drone -> drone.stage() == RunDroneStage.LANDED);
    }

    @Test
    void drivesHomeWhenTheRunIsStoppedAndIsDisarmedThere() {
        RunTestBench fleet = rover(8);
        drivesPast(fleet, 2);
        List<Command> given = new ArrayList<>();
        fleet.loses = give -> {
            given.add(give.command());
            return false;
        };
        fleet.wish(new RunInput.Stop(fleet.now, "Ann"));
        fleet.flyUntil(() -> fleet.state.isOver(), 300);

        assertThat(given.get(0)).isInstanceOf(Command.ReturnToLaunch.class);
        assertThat(isHome(fleet.vehicle(0))).isTrue();
        assertThat(fleet.vehicle(0).armed).isFalse();
        assertThat(fleet.said).noneMatch(words -> words.contains("stuck"));
    }

    @Test
    void oneThatSomebodyDroveAwayTakesPartAgainWithoutBeingDisarmed() {
        RunTestBench fleet = rover(8);
        drivesPast(fleet, 2);
        fleet.vehicle(0).mode = "LOITER";
        fleet.flyUntil(() -> fleet.drone(0).stage() == RunDroneStage.SUSPENDED, 10);
        List<Command> given = new ArrayList<>();
        fleet.loses = give -> {
            given.add(give.command());
            return false;
        };
        fleet.wish(new RunInput.ResumeDrone(fleet.now, "Ann", new DroneId("d0")));
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(8);
        assertThat(given.subList(0, given.size() - 1)).noneMatch(Command.Disarm.class::isInstance);
    }

    @Test
    void aPlaneThatCirclesOverItsHomeIsDoneAndIsSaidToBeNobodys() {
        RunTestBench fleet = RunFixtures.mixed(3, 6, VehicleKind.FIXED_WING, VehicleKind.MULTICOPTER);
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(6);
        assertThat(fleet.drone(0).stage()).isEqualTo(RunDroneStage.LEFT);
        assertThat(fleet.drone(0).note())
                .contains("Drone d0 circles over its home", "no run lands it", "take control of it and land it");
        assertThat(fleet.state.end()).contains("all 6 waypoints visited", "Drone d0 circles over its home");
        assertThat(fleet.run.drones(fleet.state)).isEmpty();
        assertThat(fleet.vehicle(0).mode).isEqualTo("RTL");
    }

    @Test
    void aPlaneThatIsCalledHomeIsSaidToCircleThere() {
        RunTestBench fleet = RunFixtures.mixed(3, 6, VehicleKind.FIXED_WING);
        drivesPast(fleet, 2);
        fleet.wish(new RunInput.Stop(fleet.now, "Ann"));
        fleet.flyUntil(() -> fleet.state.isOver(), 600);

        assertThat(fleet.state.end()).contains("Drone d0 circles over its home");
    }

    private static RunTestBench silent(VehicleKind kind) {
        RunTestBench fleet = RunFixtures.mixed(3, 6, kind);
        drivesPast(fleet, 2);
        fleet.vehicle(0).cut = true;
        fleet.flyUntil(() -> fleet.drone(0).stage() == RunDroneStage.SILENT, 60);
        return fleet;
    }

    @Test
    void aSilentRoverIsNeitherSaidToFlyNorToComeDown() {
        RunTestBench fleet = silent(VehicleKind.ROVER);
        assertThat(fleet.drone(0).note()).contains("it may still be under way");
        fleet.wish(new RunInput.Stop(fleet.now, "Ann"));
        assertThat(fleet.said.get(fleet.said.size() - 1)).endsWith("Drone d0 is not heard and may still be under way.");
        fleet.flyUntil(() -> fleet.state.isOver(), 4_000);

        assertThat(fleet.drone(0).note())
                .isEqualTo("Drone d0 was not heard again; it must have come to a stop by now.");
        assertThat(fleet.said).noneMatch(words -> words.contains(" fly") || words.contains(" down"));
    }

    @Test
    void aSilentPlaneMayCircleForAnyTime() {
        RunTestBench fleet = silent(VehicleKind.FIXED_WING);
        fleet.flyUntil(() -> fleet.state.isOver(), 4_000);

        assertThat(fleet.drone(0).note())
                .isEqualTo("Drone d0 was not heard again; it may be down, or circle over its home.");
    }

    @Test
    void aPauseOfWhatDrivesNamesNoAir() {
        RunTestBench fleet = rover(8);
        drivesPast(fleet, 2);
        fleet.wish(new RunInput.Pause(fleet.now, "Ann"));

        assertThat(fleet.said.get(fleet.said.size() - 1))
                .endsWith(" Ann paused the run: drones under way hold, the others stay where they are.");
    }
}
