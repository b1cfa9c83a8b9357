package org.dronemap.cognitive.operation.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunOrder;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Task;
import org.dronemap.cognitive.problem.TimeWindow;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.mission.MissionAbilities;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.mission.WaypointTask;
import org.junit.jupiter.api.Test;

/** One waypoint that a vehicle does not fly costs that waypoint, and neither this drone nor the next one. */
class UnflyableWaypointsTest {
    private static final MissionAbilities BLIND = MissionAbilities.ALL.without(MissionItem.Kind.LOOK_AT);

    /** So many drones, and waypoints, one of which is to be looked from. */
    private static RunTestBench fleet(int drones) {
        Task look = new Task(3, Set.of(), List.of(new WaypointTask.Look(PlanningFixtures.point(200, 200), 400)));
        List<Waypoint> waypoints = new ArrayList<>();
        for (int i = 0; i < 8; i++) {
            Waypoint plain = Waypoint.at("w" + i, PlanningFixtures.place(60.0 * (i % 4), 80 + 60.0 * (i / 4), 430));
            waypoints.add(i == 5 ? new Waypoint(plain.id(), plain.place(), look, 1, TimeWindow.ALWAYS) : plain);
        }
        List<Craft> crafts = new ArrayList<>();
        for (int i = 0; i < drones; i++) {
            crafts.add(PlanningFixtures.craft(i, 40.0 * i, 0));
        }
        return RunFixtures.fleet(
                PlanningProblem.of(waypoints, crafts),
                1,
                RunOrder.ApprovalMode.AUTOMATIC,
                MissionCloudLossPolicy.RETURN_TO_LAUNCH);
    }

    private static void allCameBackBut(RunTestBench fleet, String waypoint) {
        assertThat(fleet.state.count(RunWaypoint.State.VISITED))
                .as("%s", fleet.said)
                .isEqualTo(7);
        assertThat(fleet.state.target(waypoint).orElseThrow().state()).isEqualTo(RunWaypoint.State.UNSERVED);
        assertThat(fleet.state.drones()).allMatch(drone -> drone.stage() == RunDroneStage.LANDED);
    }

    @Test
    void oneThatNoDroneFliesIsLeftOutAloneBeforeAnythingIsSent() {
        RunTestBench fleet = fleet(4);
        fleet.vehicles.values().forEach(vehicle -> vehicle.missions = BLIND);
        List<Command> looking = new ArrayList<>();
        fleet.loses = give -> {
            if (give.command() instanceof Command.UploadMission upload
                    && upload.mission().items().stream().anyMatch(MissionItem.LookAt.class::isInstance)) {
                looking.add(upload);
            }
            return false;
        };
        fleet.flyToTheEnd();

        allCameBackBut(fleet, "w5");
        assertThat(looking).isEmpty();
        assertThat(fleet.state.target("w5").orElseThrow().reason())
                .contains("does not fly the waypoint w5", "look at", "ArduCopter");
    }

    @Test
    void anotherDroneThatFliesItGetsIt() {
        RunTestBench fleet = fleet(4);
        DroneId planned = fleet.state.target("w5").orElseThrow().drone();
        fleet.vehicles.values().forEach(vehicle -> vehicle.missions = BLIND);
        TestVehicle able = fleet.vehicles.values().stream()
                .filter(vehicle -> !vehicle.id.equals(planned))
                .findFirst()
                .orElseThrow();
        able.missions = MissionAbilities.ALL;
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED))
                .as("%s", fleet.said)
                .isEqualTo(8);
        assertThat(fleet.visits.get("w5")).containsExactly(able.id);
    }

    /** By a firmware that nobody knew to be so. */
    @Test
    void oneThatOnlyTheVehiclesThemselvesRefuseIsLeftOutAlone() {
        RunTestBench fleet = fleet(3);
        fleet.refuses = give -> give.command() instanceof Command.UploadMission upload
                        && upload.mission().items().stream().anyMatch(MissionItem.LookAt.class::isInstance)
                ? Optional.of(new Outcome.Refused(
                        "vehicle",
                        "The vehicle does not know an item of this mission.",
                        OutcomeCode.MISSION_ITEM_NOT_KNOWN))
                : Optional.empty();
        fleet.flyToTheEnd();

        allCameBackBut(fleet, "w5");
        assertThat(fleet.state.target("w5").orElseThrow().reason()).contains("does not know an item of this mission");
    }

    @Test
    void aDroneThatTakesNoMissionAtAllLeavesAlone() {
        RunTestBench fleet = fleet(3);
        DroneId full = fleet.state.target("w0").orElseThrow().drone();
        fleet.refuses = give -> give.command() instanceof Command.UploadMission
                        && give.drone().equals(full)
                ? Optional.of(new Outcome.Refused(
                        "vehicle", "The vehicle has no room for so many mission items.", OutcomeCode.MISSION_TOO_LONG))
                : Optional.empty();
        fleet.flyToTheEnd();

        RunDrone left = fleet.state.drone(full).orElseThrow();
        assertThat(left.stage()).isEqualTo(RunDroneStage.LEFT);
        assertThat(left.note()).contains("no room for so many mission items");
        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(8);
    }

    @Test
    void oneThatComesIntoAFlyingDronesPlanIsLeftOutInTheAir() {
        RunTestBench fleet = RunFixtures.fleet(2, 8, 1);
        fleet.vehicles.values().forEach(vehicle -> vehicle.missions = BLIND);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 2, 600);
        fleet.wish(new RunInput.AddWaypoints(
                fleet.now,
                "Ann",
                List.of(new Waypoint(
                        "look",
                        PlanningFixtures.place(50, 120, 430),
                        new Task(3, Set.of(), List.of(new WaypointTask.Look(PlanningFixtures.point(200, 200), 400))),
                        1,
                        TimeWindow.ALWAYS))));
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED))
                .as("%s", fleet.said)
                .isEqualTo(8);
        assertThat(fleet.state.target("look").orElseThrow().state()).isEqualTo(RunWaypoint.State.UNSERVED);
        assertThat(fleet.state.drones()).allMatch(drone -> drone.stage() == RunDroneStage.LANDED);
    }
}
