package org.dronemap.cognitive.operation.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.operation.OperationAction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Runs over a time in which the server, or a drone, was away. */
class RunCloudLossTest {
    private static int commandsTo(RunTestBench fleet, String drone) {
        return (int) fleet.decisions.stream()
                .flatMap(decision -> decision.actions().stream())
                .filter(action -> action instanceof OperationAction.SendCommand<RunInput> give
                        && give.drone().value().equals(drone))
                .count();
    }

    private static RunTestBench underWay(MissionCloudLossPolicy loss) {
        RunTestBench fleet = RunFixtures.fleet(3, 30, 1, loss);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
        return fleet;
    }

    private static RunTestBench withAFallenDrone(MissionCloudLossPolicy loss) {
        RunTestBench fleet = underWay(loss);
        fleet.vehicle(1).falling = true;
        return fleet;
    }

    @ParameterizedTest
    @ValueSource(ints = {20, 60, 120, 1_000})
    void loseNoWaypointWhereDronesFlyToTheirEndWhileTheServerIsAway(int seconds) {
        RunTestBench fleet = withAFallenDrone(MissionCloudLossPolicy.CONTINUE);
        fleet.flyUntil(() -> fleet.state.request() != null, 10);
        fleet.restart(seconds);
        fleet.fly(4);
        assertThat(fleet.state.drones()).noneMatch(RunCloudLoss::isUnclear);
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED))
                .as("%s", fleet.said)
                .isEqualTo(30);
    }

    @ParameterizedTest
    @EnumSource(
            value = RunDroneStage.class,
            names = {"HOLDING", "REPLACING", "CONTINUING"})
    void sendsDronesOutAgainThatWaitedForTheServerWhenItWentAway(RunDroneStage stage) {
        RunTestBench fleet = withAFallenDrone(MissionCloudLossPolicy.CONTINUE);
        fleet.flyUntil(() -> fleet.drone(0).stage() == stage, 30);
        fleet.restart(400);
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED))
                .as("%s", fleet.said)
                .isEqualTo(30);
    }

    @Test
    void sendsDronesOutAgainThatAreSlowToTellWhatTheyCarry() {
        RunTestBench fleet = underWay(MissionCloudLossPolicy.RETURN_TO_LAUNCH);
        fleet.restart(12);
        fleet.vehicles.values().forEach(vehicle -> vehicle.untold = 40);
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED))
                .as("%s", fleet.said)
                .isEqualTo(30);
    }

    /** What they said in the last moment was not written down, or heard by nobody. */
    @ParameterizedTest
    @ValueSource(ints = {12, 40, 90})
    void visitNothingTwiceThatTheyVisitedWhileTheServerWasAwayBeforeTheyCameHome(int seconds) {
        RunTestBench fleet = RunFixtures.fleet(3, 60, 1, MissionCloudLossPolicy.RETURN_TO_LAUNCH);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
        int before = fleet.visits.size();
        fleet.restart(seconds);
        assertThat(fleet.visits.size()).isGreaterThan(before);
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED))
                .as("%s", fleet.said)
                .isEqualTo(60);
        assertThat(fleet.visits.values()).as("%s", fleet.said).allMatch(by -> by.size() == 1);
    }

    @Test
    void sendsDronesOutAgainThatFlewToTheirEndWhileTheyWereNotHeard() {
        RunTestBench fleet = underWay(MissionCloudLossPolicy.CONTINUE);
        fleet.vehicle(0).cut = true;
        fleet.vehicle(2).cut = true;
        fleet.fly(6);
        fleet.vehicle(1).falling = true;
        fleet.flyUntil(() -> !fleet.vehicle(0).armed && !fleet.vehicle(2).armed, 1_000);
        assertThat(fleet.state.isOver()).as("%s", fleet.said).isFalse();
        fleet.vehicle(0).cut = false;
        fleet.vehicle(2).cut = false;
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED))
                .as("%s", fleet.said)
                .isEqualTo(30);
    }

    @Test
    void missesADroneAfterARestartAsSoonAsItsLinkIsLostThatWasHeardSince() {
        RunTestBench fleet = underWay(MissionCloudLossPolicy.CONTINUE);
        fleet.restart(3);
        fleet.fly(8);
        fleet.vehicle(1).cut = true;
        fleet.flyUntil(() -> fleet.drone(1).stage() == RunDroneStage.SILENT, 6);
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED))
                .as("%s", fleet.said)
                .isEqualTo(30);
    }

    @ParameterizedTest
    @EnumSource(
            value = RunDroneStage.class,
            names = {"ARMING", "FLYING", "RESUMING"})
    void waitsForADroneThatWasNotHeardSinceTheRestart(RunDroneStage stage) {
        RunTestBench fleet = RunFixtures.fleet(3, 30, 1, MissionCloudLossPolicy.CONTINUE);
        if (stage == RunDroneStage.RESUMING) {
            fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
            fleet.vehicle(1).mode = "LOITER";
            fleet.flyUntil(() -> fleet.drone(1).stage() == RunDroneStage.SUSPENDED, 10);
            fleet.wish(new RunInput.ResumeDrone(fleet.now, "Ann", fleet.vehicle(1).id));
        } else {
            fleet.flyUntil(() -> fleet.drone(1).stage() == stage, 60);
        }
        fleet.vehicle(1).cut = true;
        fleet.restart(10);
        fleet.fly(19);
        assertThat(fleet.drone(1).stage()).as("%s", fleet.said).isEqualTo(stage);
        fleet.flyUntil(() -> fleet.drone(1).stage() != stage, 2);
    }

    private static Stream<RunDrone> landed(RunTestBench fleet) {
        return fleet.state.drones().stream().filter(drone -> drone.stage() == RunDroneStage.LANDED);
    }

    @Test
    void sendsDronesOutAgainThatHadLandedWhenTheServerWentAway() {
        RunTestBench fleet = RunFixtures.fleet(3, 30, 1, MissionCloudLossPolicy.CONTINUE);
        fleet.flyUntil(() -> landed(fleet).count() == 2, 1_000);
        fleet.wish(new RunInput.AddWaypoints(
                fleet.now, "Ann", List.of(Waypoint.at("n1", PlanningFixtures.place(100, 300, 440)))));
        fleet.restart(300);
        assertThat(landed(fleet)).hasSize(2);
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED))
                .as("%s", fleet.said)
                .isEqualTo(31);
    }

    @ParameterizedTest
    @EnumSource(
            value = RunDroneStage.class,
            names = {"ARMING", "STARTING"})
    void startsDronesThatDidNotGetOffBeforeTheServerWentAway(RunDroneStage stage) {
        RunTestBench fleet = RunFixtures.fleet(3, 30, 1, MissionCloudLossPolicy.CONTINUE);
        fleet.flyUntil(() -> fleet.drone(0).stage() == stage, 60);
        fleet.restart(30);
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED))
                .as("%s", fleet.said)
                .isEqualTo(30);
        assertThat(fleet.drone(0).stage()).isEqualTo(RunDroneStage.LANDED);
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void neverTakesADroneFromItsPilotAfterARestart(boolean before) {
        RunTestBench fleet = underWay(MissionCloudLossPolicy.CONTINUE);
        TestVehicle piloted = fleet.vehicle(1);
        if (before) {
            piloted.mode = "LOITER";
            fleet.fly(2);
        }
        int given = commandsTo(fleet, "d1");
        piloted.mode = "LOITER";
        fleet.restart(30);
        fleet.fly(200);

        assertThat(fleet.drone(1).stage()).isEqualTo(RunDroneStage.SUSPENDED);
        assertThat(piloted.mode).isEqualTo("LOITER");
        assertThat(commandsTo(fleet, "d1")).isEqualTo(given);
        fleet.wish(new RunInput.ResumeDrone(fleet.now, "Ann", piloted.id));
        fleet.flyToTheEnd();
        assertThat(commandsTo(fleet, "d1")).isGreaterThan(given);
        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(30);
    }

    @ParameterizedTest
    @EnumSource(
            value = RunDroneStage.class,
            names = {"ARMING", "STARTING", "FLYING"})
    void leavesADroneToThePilotWhoTookItFromTheGroundWhileTheServerWasAway(RunDroneStage stage) {
        RunTestBench fleet = RunFixtures.fleet(3, 30, 1, MissionCloudLossPolicy.CONTINUE);
        fleet.flyUntil(() -> fleet.drone(1).stage() == stage, 60);
        TestVehicle piloted = fleet.vehicle(1);
        piloted.armed = true;
        piloted.mode = "LOITER";
        piloted.altitude += 10;
        fleet.restart(3);
        fleet.fly(30);

        assertThat(fleet.drone(1).stage()).isEqualTo(RunDroneStage.SUSPENDED);
        assertThat(piloted.mode).isEqualTo("LOITER");
    }

    @Test
    void leavesADroneThatAPilotStoppedWhileItWasNotHeard() {
        RunTestBench fleet = underWay(MissionCloudLossPolicy.CONTINUE);
        fleet.vehicle(1).cut = true;
        fleet.flyUntil(() -> fleet.drone(1).stage() == RunDroneStage.SILENT, 10);
        fleet.vehicle(1).mode = "BRAKE";
        fleet.vehicle(1).cut = false;
        fleet.fly(30);

        assertThat(fleet.drone(1).stage()).isEqualTo(RunDroneStage.SUSPENDED);
        assertThat(fleet.vehicle(1).mode).isEqualTo("BRAKE");
    }
}
