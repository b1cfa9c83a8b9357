package org.dronemap.cognitive.operation.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunExplanation;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunOrder;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.EnergyBudget;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.zone.AltitudeBand;
import org.junit.jupiter.api.Test;

/** What users want of a run that is going on. */
class RunUserRequestsTest {
    private static RunTestBench flying(RunOrder.ApprovalMode mode) {
        RunTestBench fleet = RunFixtures.fleet(
                RunFixtures.problem(3, 30, 1, false), 1, mode, MissionCloudLossPolicy.RETURN_TO_LAUNCH);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
        return fleet;
    }

    private static RunTestBench flying() {
        return flying(RunOrder.ApprovalMode.AUTOMATIC);
    }

    private static RunExplanation last(RunTestBench fleet, RunTrigger trigger) {
        return fleet.state.explanations().stream()
                .filter(each -> each.trigger() == trigger)
                .reduce((one, other) -> other)
                .orElseThrow();
    }

    @Test
    void visitWaypointsThatAreAdded() {
        RunTestBench fleet = flying();
        RunFixtures.addTwoWaypoints(fleet);
        fleet.fly(1);

        assertThat(fleet.state.target("n1").orElseThrow().state()).isEqualTo(RunWaypoint.State.ASSIGNED);
        RunExplanation told = last(fleet, RunTrigger.WAYPOINTS_ADDED);
        assertThat(told.words()).startsWith("Ann added 2 waypoints: n1, n2.").contains("from nobody to Drone");
        assertThat(told.moved()).hasSize(2);
        assertThat(told.after()).isNotNull();
        assertThat(fleet.said).anyMatch(said -> said.endsWith(told.words()));
        fleet.flyToTheEnd();
        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(32);
    }

    @Test
    void visitAMovedWaypointWhereItIsNow() {
        RunTestBench fleet = flying();
        String next = fleet.drone(0).orders().get(0);
        fleet.wish(new RunInput.MoveWaypoint(fleet.now, "Ann", next, PlanningFixtures.place(-450, 450, 445)));
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(30);
        assertThat(fleet.visits).containsKey(next);
    }

    @Test
    void leaveOutACancelledWaypoint() {
        RunTestBench fleet = flying();
        String later = fleet.drone(0).orders().get(2);
        fleet.wish(new RunInput.CancelWaypoint(fleet.now, "Ann", later));
        fleet.flyToTheEnd();

        assertThat(fleet.visits).doesNotContainKey(later);
        assertThat(fleet.state.count(RunWaypoint.State.CANCELLED)).isEqualTo(1);
        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(29);
        assertThat(fleet.state.end()).isEqualTo("The run is over: all 29 waypoints visited.");
    }

    @Test
    void keepOutOfANewFence() {
        RunTestBench fleet = flying();
        Barrier barrier = new Barrier(
                "the no-fly zone “Crane”",
                new FenceArea.Circle(false, PlanningFixtures.point(-250, 0), 60),
                AltitudeBand.ALL,
                Set.of());
        fleet.wish(new RunInput.AddBarrier(fleet.now, "Ann", barrier));
        fleet.fly(4);
        while (!fleet.state.isOver()) {
            fleet.fly(0.25);
            fleet.vehicles.values().stream()
                    .filter(TestVehicle::isUp)
                    .forEach(vehicle -> assertThat(Math.hypot(vehicle.east + 250, vehicle.north))
                            .as("%s; %s", vehicle.id, fleet.said)
                            .isGreaterThan(60));
        }
        fleet.flyToTheEnd();
        assertThat(fleet.state.targets())
                .filteredOn(target -> target.state() == RunWaypoint.State.UNSERVED)
                .allMatch(target -> target.reason() != null && !target.reason().isBlank());
    }

    @Test
    void letADroneJoin() {
        RunTestBench fleet = flying();
        Craft craft = PlanningFixtures.craft(7, 200, 0);
        fleet.vehicles.put(craft.id(), new TestVehicle(7, 200, 0));
        fleet.wish(new RunInput.JoinDrone(fleet.now, "Ann", craft, "Drone d7", VehicleKind.MULTICOPTER));
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(30);
        assertThat(fleet.state.targets())
                .anyMatch(target -> target.visits().get(0).drone().equals(new DroneId("d7")));
    }

    private static RunTestBench limited() {
        RunTestBench fleet = RunFixtures.limited(3, 30, 1);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
        return fleet;
    }

    private static TestVehicle join(RunTestBench fleet) {
        Craft craft = PlanningFixtures.craft(7, 200, 0).with(new EnergyBudget(150_000, 30_000));
        TestVehicle vehicle = new TestVehicle(7, 200, 0);
        vehicle.fullJoules = 150_000;
        vehicle.joules = 150_000;
        fleet.vehicles.put(craft.id(), vehicle);
        fleet.wish(new RunInput.JoinDrone(fleet.now, "Ann", craft, "Drone d7", VehicleKind.MULTICOPTER));
        return vehicle;
    }

    private static void addOutOfReach(RunTestBench fleet) {
        fleet.wish(new RunInput.AddWaypoints(
                fleet.now, "Ann", List.of(Waypoint.at("far", PlanningFixtures.place(0, 30_000, 440)))));
    }

    @Test
    void tellWhyNobodyVisitsAWaypointThatIsOutOfReach() {
        RunTestBench fleet = limited();
        addOutOfReach(fleet);
        fleet.fly(3);

        String why = fleet.state.target("far").orElseThrow().reason();
        assertThat(why).startsWith("Out of range");
        fleet.flyToTheEnd();
        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(30);
        assertThat(fleet.state.target("far").orElseThrow().state()).isEqualTo(RunWaypoint.State.UNSERVED);
        assertThat(fleet.state.target("far").orElseThrow().reason()).startsWith("Out of range");
    }

    @Test
    void giveAJoiningDroneItsShareThoughAWaypointIsOutOfReach() {
        RunTestBench fleet = limited();
        addOutOfReach(fleet);
        fleet.fly(6);
        TestVehicle joined = join(fleet);
        fleet.flyToTheEnd();

        assertThat(joined.visits).as("%s", fleet.said).isNotEmpty();
        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(30);
    }

    @Test
    void giveAJoiningDroneItsShareThoughItIsHeldLate() {
        RunTestBench fleet = flying();
        TestVehicle joined = join(fleet);
        joined.takenBy = "Nobody has it yet.";
        fleet.fly(6);
        joined.takenBy = null;
        fleet.flyToTheEnd();

        assertThat(joined.visits).as("%s", fleet.said).isNotEmpty();
    }

    @Test
    void tellWhyNobodyVisitsWhatLiesInANewFence() {
        RunTestBench fleet = flying();
        String fenced = fleet.drone(0).orders().get(2);
        fleet.wish(new RunInput.AddBarrier(
                fleet.now,
                "Ann",
                new Barrier(
                        "the no-fly zone “Crane”",
                        new FenceArea.Circle(
                                false,
                                fleet.state
                                        .target(fenced)
                                        .orElseThrow()
                                        .waypoint()
                                        .place()
                                        .point(),
                                30),
                        AltitudeBand.ALL,
                        Set.of())));
        fleet.fly(2);
        String why = "It lies where the no-fly zone “Crane” keeps drones from.";
        assertThat(last(fleet, RunTrigger.FENCE_ADDED).words()).contains(fenced + " has nobody: " + why);
        fleet.flyToTheEnd();

        assertThat(fleet.state.target(fenced).orElseThrow().reason()).isEqualTo(why);
        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(29);
    }

    @Test
    void takeADroneOut() {
        RunTestBench fleet = flying();
        fleet.wish(new RunInput.GiveUpDrone(fleet.now, "Ann", fleet.vehicle(1).id));
        fleet.fly(2);
        assertThat(fleet.vehicle(1).mode).isEqualTo("RTL");
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(30);
        assertThat(fleet.drone(1).stage()).isEqualTo(RunDroneStage.LEFT);
    }

    @Test
    void callAllHomeOnStop() {
        RunTestBench fleet = flying();
        fleet.wish(new RunInput.Stop(fleet.now, "Ann"));
        fleet.fly(2);
        assertThat(fleet.vehicles.values()).allMatch(vehicle -> vehicle.mode.equals("RTL"));
        fleet.flyToTheEnd();

        assertThat(fleet.state.targets())
                .filteredOn(target -> target.state() != RunWaypoint.State.VISITED)
                .isNotEmpty()
                .allMatch(target -> "The run was stopped by Ann.".equals(target.reason()));
        assertThat(fleet.drone(0).stage()).as("%s", fleet.said).isEqualTo(RunDroneStage.LANDED);
    }

    @Test
    void askFirst() {
        RunTestBench fleet = flying(RunOrder.ApprovalMode.ASK_FIRST);
        fleet.vehicle(1).falling = true;
        fleet.flyUntil(() -> fleet.state.proposal() != null, 20);
        assertThat(fleet.drone(1).stage()).isEqualTo(RunDroneStage.CRASHED);
        assertThat(fleet.state.counts().replans()).isZero();
        long waiting = fleet.state.count(RunWaypoint.State.WAITING);
        assertThat(waiting).isPositive();
        fleet.fly(20);
        assertThat(fleet.state.count(RunWaypoint.State.WAITING)).isEqualTo(waiting);

        fleet.wish(new RunInput.AnswerProposal(fleet.now, "Ann", 1, true));
        fleet.fly(3);
        assertThat(fleet.state.count(RunWaypoint.State.WAITING)).isZero();
        fleet.flyToTheEnd();
        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(30);
    }

    @Test
    void goOnWithoutWhatSomebodySaidNoTo() {
        RunTestBench fleet = flying(RunOrder.ApprovalMode.ASK_FIRST);
        fleet.vehicle(1).falling = true;
        fleet.flyUntil(() -> fleet.state.proposal() != null, 20);
        fleet.wish(new RunInput.AnswerProposal(fleet.now, "Ann", 1, false));
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.UNSERVED)).isPositive();
    }

    @Test
    void areRefusedWithASentence() {
        RunTestBench fleet = flying();
        String done = fleet.state.targets().stream()
                .filter(target -> target.state() == RunWaypoint.State.VISITED)
                .findFirst()
                .orElseThrow()
                .id();

        assertThat(refusal(fleet, new RunInput.CancelWaypoint(fleet.now, "Ann", done)))
                .isEqualTo("The waypoint " + done + " is settled: visited.");
        assertThat(refusal(fleet, new RunInput.CancelWaypoint(fleet.now, "Ann", "x")))
                .isEqualTo("The run has no waypoint x.");
        assertThat(refusal(fleet, new RunInput.ResumeDrone(fleet.now, "Ann", fleet.vehicle(0).id)))
                .isEqualTo("Drone d0 does not wait for being resumed.");
        assertThat(refusal(fleet, new RunInput.AnswerProposal(fleet.now, "Ann", 1, true)))
                .isEqualTo("There is no proposal 1 that waits for an answer.");
    }

    private static String refusal(RunTestBench fleet, RunInput wish) {
        return fleet.run.refusal(fleet.state, wish).orElseThrow().sentence();
    }
}
