package org.dronemap.cognitive.operation.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunOrder;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Task;
import org.dronemap.cognitive.problem.TimeWindow;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.drone.DroneId;
import org.junit.jupiter.api.Test;

/** What a run says of its drones is so, and stops being said when it is so no longer. */
class TrueMessagesTest {
    private static RunTestBench silent() {
        RunTestBench fleet = RunFixtures.fleet(3, 15, 4, MissionCloudLossPolicy.CONTINUE);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 2, 600);
        fleet.vehicle(1).cut = true;
        fleet.flyUntil(() -> fleet.drone(1).stage() == RunDroneStage.SILENT, 30);
        return fleet;
    }

    @Test
    void aWaypointThatIsCancelledIsNotSaidToBeReservedAnyMore() {
        RunTestBench fleet = silent();
        String reserved = fleet.drone(1).orders().get(0);
        assertThat(fleet.drone(1).note()).contains("(" + reserved, "reserved for it");
        fleet.wish(new RunInput.CancelWaypoint(fleet.now, "Ann", reserved));
        fleet.fly(1);

        assertThat(fleet.drone(1).note()).doesNotContain(reserved);
    }

    @Test
    void whatOthersFlyAfterAWhileIsNotSaidToBeReservedAnyMore() {
        RunTestBench fleet = silent();
        fleet.flyUntil(() -> fleet.drone(1).orders().isEmpty(), 300);
        assertThat(fleet.drone(1).stage()).isEqualTo(RunDroneStage.SILENT);

        assertThat(fleet.drone(1).note()).contains("Nothing is reserved for it");
    }

    @Test
    void oneThatWasSilentOnTheGroundIsNotSaidToBeWhenItIsHeard() {
        RunTestBench fleet = RunFixtures.fleet(2, 8, 1);
        fleet.loses = give -> give.command() instanceof Command.UploadMission;
        fleet.fly(1);
        fleet.vehicle(1).cut = true;
        fleet.flyUntil(() -> fleet.drone(1).note() != null, 30);
        assertThat(fleet.drone(1).note()).contains("stands on the ground");
        fleet.vehicle(1).cut = false;
        fleet.fly(3);

        assertThat(fleet.drone(1).note()).isNull();
        assertThat(fleet.said).anyMatch(words -> words.contains("Drone d1 is heard again; it is on the ground"));
    }

    @Test
    void aStopFreesWhoeverIsDownAtOnceAndKeepsTheSilentOne() {
        RunTestBench fleet = silent();
        fleet.wish(new RunInput.Stop(fleet.now, "Ann"));
        assertThat(fleet.said.get(fleet.said.size() - 1))
                .contains("stopped by Ann", "Drone d0, Drone d2 come home", "Drone d1 is not heard and may still fly");
        fleet.flyUntil(() -> !fleet.vehicle(0).armed && !fleet.vehicle(2).armed, 300);
        fleet.fly(3);

        assertThat(fleet.state.isOver()).isFalse();
        assertThat(fleet.run.drones(fleet.state)).containsExactly(new DroneId("d1"));
        assertThat(fleet.vehicle(0).returnMeters).as("as its owner had set it").isEqualTo(15);
        assertThat(List.of(fleet.drone(0).stage(), fleet.drone(2).stage())).containsOnly(RunDroneStage.LANDED);
        fleet.vehicle(0).takenBy = "Bob has control.";
        fleet.fly(5);
        assertThat(fleet.drone(0).stage()).isEqualTo(RunDroneStage.LANDED);
        assertThat(fleet.said).noneMatch(words -> words.contains("Somebody who goes first"));
        fleet.flyToTheEnd();
    }

    @Test
    void aStopBeforeAnybodySetOffSaysSo() {
        RunTestBench fleet = RunFixtures.fleet(2, 8, 1);
        fleet.fly(0.5);
        fleet.wish(new RunInput.Stop(fleet.now, "Ann"));

        assertThat(fleet.said.get(fleet.said.size() - 1)).contains("No drone is under way");
    }

    /** Its place in the mission is told before it has gathered speed. */
    @Test
    void oneThatWaitedLongAtAWaypointIsNotSaidNotToMoveOn() {
        Task stay = new Task(50, Set.of());
        List<Waypoint> waypoints = List.of(
                new Waypoint("w0", PlanningFixtures.place(60, 60, 430), stay, 1, TimeWindow.ALWAYS),
                Waypoint.at("w1", PlanningFixtures.place(60, 200, 430)));
        RunTestBench fleet = RunFixtures.fleet(
                PlanningProblem.of(waypoints, List.of(PlanningFixtures.craft(0, 0, 0))),
                1,
                RunOrder.ApprovalMode.AUTOMATIC,
                MissionCloudLossPolicy.RETURN_TO_LAUNCH);
        fleet.vehicle(0).hesitates = 2;
        fleet.flyToTheEnd();

        assertThat(fleet.said).noneMatch(words -> words.contains("does not move on") || words.contains("is late"));
        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(2);
    }

    @Test
    void nobodyIsSaidToHaveSetOffBeforeItHas() {
        RunTestBench fleet = RunFixtures.fleet(4, 12, 1);
        fleet.flyUntil(() -> fleet.state.clock().launched(), 60);

        assertThat(fleet.state.explanations().get(0).words())
                .isEqualTo("The missions of 4 drones are on board; each is armed and started at its time.");
    }

    /** Its pilot may have, or another ground station, or a fail-safe. */
    @Test
    void nobodyIsNamedForAWayHomeThatTheRunDidNotAskFor() {
        RunTestBench fleet = RunFixtures.fleet(2, 8, 1);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 1, 600);
        fleet.vehicle(1).mode = "RTL";
        fleet.fly(3);

        assertThat(fleet.said)
                .anyMatch(
                        words -> words.endsWith(" Drone d1 comes home or down (RTL), which this run did not ask for."));
    }

    @Test
    void oneThatIsOnlyBeingArmedIsNotSaidToComeHome() {
        RunTestBench fleet = RunFixtures.fleet(1, 8, 1);
        fleet.flyUntil(() -> fleet.drone(0).stage() == RunDroneStage.ARMING, 60);
        fleet.wish(new RunInput.Stop(fleet.now, "Ann"));

        assertThat(fleet.said.get(fleet.said.size() - 1)).endsWith("stopped by Ann. Drone d0 stays where it is.");
    }

    @Test
    void aNameMayHaveAnySign() {
        RunTestBench fleet = RunFixtures.fleet(2, 8, 1);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 1, 600);
        fleet.wish(new RunInput.GiveUpDrone(fleet.now, "Ann 100 % sure", new DroneId("d1")));

        assertThat(fleet.said).anyMatch(words -> words.endsWith(" Ann 100 % sure took Drone d1 out of the run."));
    }
}
