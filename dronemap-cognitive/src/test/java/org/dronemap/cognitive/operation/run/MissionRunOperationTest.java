package org.dronemap.cognitive.operation.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Collectors;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunExplanation;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunOrder;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.problem.Objective;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.operation.OperationAction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A run from its start to its end, and what happens on the way. */
class MissionRunOperationTest {
    static RunTestBench fleet(int drones, int waypoints) {
        return RunFixtures.fleet(drones, waypoints, 1);
    }

    static List<RunTrigger> triggers(RunTestBench fleet) {
        return fleet.state.explanations().stream().map(RunExplanation::trigger).collect(Collectors.toList());
    }

    @Test
    void fliesThePlanAndEndsWhenAllAreDown() {
        RunTestBench fleet = fleet(3, 12);

        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(12);
        assertThat(triggers(fleet)).containsExactly(RunTrigger.START, RunTrigger.ENDED);
        assertThat(fleet.state.end()).isEqualTo("The run is over: all 12 waypoints visited.");
        assertThat(fleet.vehicles.values()).noneMatch(vehicle -> vehicle.armed);
        assertThat(fleet.closest).isGreaterThan(9.9);
    }

    @Test
    void startsNobodyBeforeAllHaveTheirMissions() {
        RunTestBench fleet = fleet(3, 12);
        AtomicInteger lost = new AtomicInteger();
        fleet.loses = give -> give.drone().value().equals("d1") && lost.incrementAndGet() < 3;

        fleet.flyUntil(() -> fleet.vehicle(0).armed, 60);

        assertThat(fleet.vehicles.values()).allMatch(vehicle -> !vehicle.items.isEmpty());
        fleet.flyToTheEnd();
        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(12);
    }

    @Test
    void givesNobodyUpOnTheGroundThatAnotherTransferKeepsBusy() {
        RunTestBench fleet = fleet(3, 12);
        fleet.vehicle(1).transfer = "read the mission";
        fleet.fly(200);
        assertThat(fleet.drone(1).stage()).as("%s", fleet.said).isEqualTo(RunDroneStage.UPLOADING);

        fleet.vehicle(1).transfer = null;
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(12);
        assertThat(fleet.vehicle(1).visits).isNotEmpty();
    }

    /** The first one gets a new mission since the second one fell, and cannot take it for a hundred seconds. */
    private static RunTestBench keptBusyInTheAir() {
        RunTestBench fleet = fleet(3, 30);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
        fleet.vehicle(0).transfer = "read the mission";
        fleet.vehicle(1).falling = true;
        fleet.flyUntil(() -> fleet.drone(0).stage() == RunDroneStage.REPLACING, 60);
        fleet.fly(100);
        return fleet;
    }

    @Test
    void givesNobodyUpInTheAirThatAnotherTransferKeepsBusy() {
        RunTestBench fleet = keptBusyInTheAir();
        assertThat(fleet.drone(0).stage()).as("%s", fleet.said).isEqualTo(RunDroneStage.REPLACING);

        fleet.vehicle(0).transfer = null;
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED))
                .as("%s", fleet.said)
                .isEqualTo(30);
    }

    /** Over a bad link that takes a minute; called late each time, it got another mission again and again. */
    @Test
    void callsNobodyLateForHowLongItsMissionTookToComeOnBoard() {
        RunTestBench fleet = keptBusyInTheAir();
        fleet.vehicle(0).transfer = null;
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED))
                .as("%s", fleet.said)
                .isEqualTo(30);
        assertThat(triggers(fleet)).as("%s", fleet.said).doesNotContain(RunTrigger.LATE);
    }

    @Test
    void fliesWithoutADroneThatCannotBeBroughtItsMission() {
        RunTestBench fleet = fleet(3, 12);
        fleet.loses = give -> give.drone().value().equals("d1");
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(12);
        assertThat(fleet.drone(1).stage()).isEqualTo(RunDroneStage.LEFT);
        assertThat(triggers(fleet)).containsSubsequence(RunTrigger.COMMAND_FAILED, RunTrigger.START);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 100})
    void armsADroneAgainThatDisarmedItselfButNotForEver(int often) {
        RunTestBench fleet = fleet(3, 12);
        AtomicInteger disarmed = new AtomicInteger();
        fleet.loses = give -> {
            boolean start = give.command() instanceof Command.StartMission
                    && give.drone().value().equals("d1");
            boolean lost = start && disarmed.incrementAndGet() <= often;
            fleet.vehicle(1).armed &= !lost;
            return lost;
        };
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(12);
        assertThat(disarmed.get()).isLessThanOrEqualTo(3);
        assertThat(fleet.drone(1).stage()).isEqualTo(often == 1 ? RunDroneStage.LANDED : RunDroneStage.LEFT);
    }

    @Test
    void leavesADroneAtOnceThatAPilotTook() {
        RunTestBench fleet = fleet(3, 30);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);

        fleet.vehicle(1).mode = "LOITER";
        fleet.vehicle(1).takenBy = "Pilot has it.";
        int given = commandsTo(fleet, "d1");
        fleet.fly(0.5);
        assertThat(fleet.drone(1).stage()).isEqualTo(RunDroneStage.SUSPENDED);
        fleet.fly(60);

        assertThat(commandsTo(fleet, "d1")).isEqualTo(given);
        assertThat(fleet.drone(1).orders()).isEmpty();
        fleet.vehicle(1).mode = "RTL";
        fleet.flyToTheEnd();
        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(30);
        assertThat(commandsTo(fleet, "d1")).isEqualTo(given);
    }

    private static int commandsTo(RunTestBench fleet, String drone) {
        return (int) fleet.decisions.stream()
                .flatMap(decision -> decision.actions().stream())
                .filter(action -> action instanceof OperationAction.SendCommand<RunInput> give
                        && give.drone().value().equals(drone))
                .count();
    }

    @Test
    void takesADroneBackOnceItIsResumed() {
        RunTestBench fleet = fleet(2, 30);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
        fleet.vehicle(1).mode = "LOITER";
        fleet.fly(20);
        assertThat(fleet.drone(1).stage()).isEqualTo(RunDroneStage.SUSPENDED);

        fleet.wish(new RunInput.ResumeDrone(fleet.now, "Ann", fleet.vehicle(1).id));
        fleet.flyUntil(() -> fleet.drone(1).stage() == RunDroneStage.FLYING, 30);

        assertThat(fleet.drone(1).orders()).isNotEmpty();
        fleet.flyToTheEnd();
        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(30);
    }

    @Test
    void reservesTheNextWaypointsOfASilentDroneAndGivesTheRestAway() {
        RunTestBench fleet = fleet(3, 30);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);

        fleet.vehicle(1).cut = true;
        fleet.flyUntil(() -> fleet.drone(1).stage() == RunDroneStage.SILENT, 5.6);
        assertThat(fleet.state.count(RunWaypoint.State.RESERVED)).isGreaterThan(0);
        fleet.flyUntil(() -> fleet.state.counts().replans() > 0 && changed(fleet), 3);

        fleet.flyToTheEnd();
        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(30);
        assertThat(fleet.drone(1).stage()).isEqualTo(RunDroneStage.GONE);
        assertThat(triggers(fleet)).contains(RunTrigger.LOST, RunTrigger.GONE);
    }

    /** All have acknowledged what they are to fly. */
    static boolean changed(RunTestBench fleet) {
        return fleet.state.drones().stream().allMatch(drone -> drone.next() == null);
    }

    @ParameterizedTest
    @ValueSource(ints = {12, 150})
    void sendsDronesOutAgainThatCameHomeSinceTheyMissedTheCloud(int seconds) {
        RunTestBench fleet = fleet(3, 30);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
        fleet.vehicles.values().forEach(vehicle -> vehicle.cut = true);
        fleet.fly(seconds);
        assertThat(fleet.state.isOver()).as("%s", fleet.said).isFalse();
        fleet.vehicles.values().forEach(vehicle -> vehicle.cut = false);

        fleet.flyToTheEnd();
        assertThat(fleet.state.count(RunWaypoint.State.VISITED))
                .as("%s", fleet.said)
                .isEqualTo(30);
    }

    @Test
    void reconcilesWhatADroneReachedWhileItWasNotHeard() {
        RunTestBench fleet = RunFixtures.fleet(3, 40, 1, MissionCloudLossPolicy.CONTINUE);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
        fleet.vehicle(1).cut = true;
        fleet.fly(90);
        fleet.vehicle(1).cut = false;
        fleet.fly(3);

        assertThat(fleet.drone(1).stage()).isNotEqualTo(RunDroneStage.SILENT);
        fleet.flyToTheEnd();
        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(40);
        assertThat(triggers(fleet)).contains(RunTrigger.HEARD_AGAIN);
    }

    @Test
    void seesThatADroneFellBackInItsTakeOff() {
        RunTestBench fleet = fleet(3, 30);
        fleet.flyUntil(() -> fleet.drone(1).stage() == RunDroneStage.FLYING, 60);
        fleet.fly(2);
        fleet.vehicle(1).falling = true;

        fleet.flyUntil(() -> fleet.drone(1).stage() == RunDroneStage.CRASHED, 6);
        fleet.flyToTheEnd();
        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(30);
    }

    @Test
    void leavesDronesOnTheGroundWhereLessIsLeftThanThereAreDrones() {
        PlanningProblem some = RunFixtures.problem(3, 12, 1, false);
        Objective every = new Objective(1, Objective.Measure.SECONDS, 0, true);
        PlanningProblem problem =
                new PlanningProblem(some.waypoints(), some.crafts(), some.barriers(), some.wind(), every, some.rules());
        RunTestBench fleet =
                RunFixtures.fleet(problem, 1, RunOrder.ApprovalMode.AUTOMATIC, MissionCloudLossPolicy.CONTINUE);
        fleet.flyUntil(
                () -> fleet.state.drones().stream()
                                .filter(drone -> drone.stage() == RunDroneStage.LANDED)
                                .count()
                        == 2,
                1_000);
        fleet.wish(new RunInput.AddWaypoints(
                fleet.now, "Ann", List.of(Waypoint.at("n1", PlanningFixtures.place(100, 300, 440)))));
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED))
                .as("%s", fleet.said)
                .isEqualTo(13);
    }

    @Test
    void takesADroneBackIntoAccountThatFliesAfterAll() {
        RunTestBench fleet = fleet(3, 30);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
        TestVehicle mistaken = fleet.vehicle(1);
        mistaken.falling = true;
        fleet.flyUntil(() -> fleet.drone(1).stage() == RunDroneStage.CRASHED, 2);
        mistaken.falling = false;
        fleet.flyUntil(() -> fleet.drone(1).stage() == RunDroneStage.SUSPENDED, 8);

        assertThat(fleet.said).anyMatch(said -> said.contains("was taken for crashed, but flies in mode AUTO"));
        int given = commandsTo(fleet, "d1");
        fleet.fly(10);
        assertThat(commandsTo(fleet, "d1")).isEqualTo(given);
        fleet.wish(new RunInput.ResumeDrone(fleet.now, "Ann", mistaken.id));
        fleet.flyToTheEnd();
        assertThat(fleet.drone(1).stage()).isEqualTo(RunDroneStage.LANDED);
        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(30);
    }

    @Test
    void takesWaypointsFromADroneWhoseBatteryRunsLow() {
        RunTestBench fleet = RunFixtures.limited(3, 30, 1);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);

        TestVehicle weak = fleet.vehicle(1);
        weak.joules = 0.32 * weak.fullJoules;
        fleet.fly(5);

        assertThat(triggers(fleet)).contains(RunTrigger.LOW_BATTERY);
        fleet.flyToTheEnd();
        assertThat(weak.joules).isGreaterThan(0.15 * weak.fullJoules);
        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(30);
    }

    @Test
    void givesAwayWhatADroneLeavesThatGoesHomeByItself() {
        RunTestBench fleet = fleet(3, 30);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
        fleet.vehicle(2).mode = "RTL";
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(30);
        assertThat(triggers(fleet)).contains(RunTrigger.WENT_HOME);
    }

    @Test
    void goesOnAfterARestart() {
        RunTestBench fleet = fleet(3, 30);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
        fleet.vehicle(1).falling = true;
        fleet.flyUntil(() -> fleet.state.request() != null, 10);
        fleet.restart(4);
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(30);
        assertThat(Duration.between(RunTestBench.START, fleet.now)).isLessThan(Duration.ofMinutes(20));
    }

    @Test
    void givesAWaypointToNobodyBeforeWhoHadItHasStopped() {
        RunTestBench fleet = fleet(3, 40);
        AtomicInteger lost = new AtomicInteger();
        fleet.loses = give -> give.command() instanceof Command.PauseMission
                && !give.drone().value().equals("d2")
                && lost.incrementAndGet() % 3 != 0;
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
        fleet.vehicle(2).falling = true;
        fleet.flyToTheEnd();

        assertThat(lost.get()).isGreaterThan(2);
        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(40);
    }

    @Test
    void makesADroneWaitForOneThatIsWhereItsPlanDoesNotSay() {
        RunTestBench fleet = fleet(3, 30);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
        TestVehicle slow = fleet.vehicle(0);
        TestVehicle other = fleet.vehicle(1);
        slow.cruise = 0;
        slow.east = other.east + 60 * Math.signum(next(fleet, other).eastMeters() - other.east);
        slow.north = other.north
                + (next(fleet, other).northMeters() - other.north)
                        / Math.abs(next(fleet, other).eastMeters() - other.east)
                        * 60;
        slow.altitude = other.altitude;
        fleet.closest = Double.POSITIVE_INFINITY;
        fleet.fly(8);

        assertThat(triggers(fleet)).contains(RunTrigger.TOO_NEAR);
        assertThat(fleet.closest).isGreaterThan(10);
    }

    private static PlanePoint next(RunTestBench fleet, TestVehicle vehicle) {
        MissionItem.Waypoint item = (MissionItem.Waypoint) vehicle.items.get(vehicle.current);
        return new LocalPlane(PlanningFixtures.point(0, 0)).spot(item.point());
    }
}
