package org.dronemap.cognitive.operation.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.List;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.safety.SafetyTimes;
import org.junit.jupiter.api.Test;

/** A drone hovers where nobody can move it: a pilot has it, or it is not heard. */
class DroneObstaclesTest {
    private static RunTestBench withOneThatHoversBesideAWaypoint() {
        RunTestBench fleet = RunFixtures.fleet(3, 18, 1, MissionCloudLossPolicy.RETURN_TO_LAUNCH);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
        TestVehicle hovers = fleet.vehicle(1);
        hovers.mode = "LOITER";
        fleet.fly(10);
        Waypoint beside = Waypoint.at("beside", PlanningFixtures.place(hovers.east + 4, hovers.north, hovers.altitude));
        fleet.wish(new RunInput.AddWaypoints(fleet.now, "Ann", List.of(beside)));
        return fleet;
    }

    @Test
    void othersFlyRoundItAndSayWhyTheyLeaveOutWhatLiesThere() {
        RunTestBench fleet = withOneThatHoversBesideAWaypoint();
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) == 18, 900);
        fleet.fly(120);

        RunWaypoint beside = fleet.state.target("beside").orElseThrow();
        assertThat(beside.reason())
                .isEqualTo("It lies where Drone d1, which stands in the air there, keeps drones from.");
        assertThat(fleet.closest).as("%s; %s", fleet.where, fleet.said).isGreaterThanOrEqualTo(10);
    }

    @Test
    void whatItStoodBesideIsServedWhenItIsGone() {
        RunTestBench fleet = withOneThatHoversBesideAWaypoint();
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) == 18, 900);
        fleet.vehicle(1).mode = "RTL";
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED))
                .as("%s", fleet.said)
                .isEqualTo(19);
        assertThat(fleet.closest).as("%s; %s", fleet.where, fleet.said).isGreaterThanOrEqualTo(10);
    }

    /** All wait in the air when it falls silent; it stays there, as its fail-safe is off. */
    private static RunTestBench withOneThatHoversUnheardBesideAWaypoint() {
        RunTestBench fleet = RunFixtures.fleet(3, 18, 1, MissionCloudLossPolicy.RETURN_TO_LAUNCH);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
        fleet.wish(new RunInput.Pause(fleet.now, "Ann"));
        fleet.flyUntil(() -> fleet.drone(1).stage() == RunDroneStage.HOLDING && fleet.vehicle(1).stillFor > 2, 30);
        TestVehicle hovers = fleet.vehicle(1);
        hovers.withoutFailSafe = true;
        hovers.cut = true;
        fleet.flyUntil(() -> fleet.drone(1).stage() == RunDroneStage.SILENT, 10);
        Waypoint beside = Waypoint.at("beside", PlanningFixtures.place(hovers.east + 4, hovers.north, hovers.altitude));
        fleet.wish(new RunInput.AddWaypoints(fleet.now, "Ann", List.of(beside)));
        fleet.wish(new RunInput.Resume(fleet.now, "Ann"));
        return fleet;
    }

    @Test
    void nobodyIsSentToWhereOneThatIsNotHeardMayHoverAndTheWaypointSaysUntilWhen() {
        RunTestBench fleet = withOneThatHoversUnheardBesideAWaypoint();
        int before = fleet.state.counts().replans();
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) == 18, 900);
        fleet.fly(240);

        Instant until = fleet.drone(1).flags().linkLoss().lastContact().plus(SafetyTimes.LONGEST_HOVER);
        assertThat(fleet.state.target("beside").orElseThrow().reason())
                .isEqualTo("It lies where Drone d1, which was last heard there and may still be there until "
                        + DateTimeFormatter.ofPattern("HH:mm:ss").format(until.atZone(ZoneOffset.UTC))
                        + " UTC, keeps drones from.");
        assertThat(fleet.state.isOver()).isFalse();
        assertThat(fleet.closest).as("%s; %s", fleet.where, fleet.said).isGreaterThanOrEqualTo(10);
        assertThat(fleet.state.counts().replans() - before).as("%s", fleet.said).isLessThan(12);
    }

    @Test
    void whatLiesThereIsServedWhenItIsHeardAgain() {
        RunTestBench fleet = withOneThatHoversUnheardBesideAWaypoint();
        fleet.fly(60);
        fleet.vehicle(1).cut = false;
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED))
                .as("%s", fleet.said)
                .isEqualTo(19);
        assertThat(fleet.closest).as("%s; %s", fleet.where, fleet.said).isGreaterThanOrEqualTo(10);
    }

    @Test
    void whatLiesThereIsServedWhenNoBatteryLastsAnyLonger() {
        RunTestBench fleet = withOneThatHoversUnheardBesideAWaypoint();
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) == 18, 900);
        fleet.fly(SafetyTimes.LONGEST_HOVER.toSeconds() - 600);
        assertThat(fleet.drone(1).stage()).isEqualTo(RunDroneStage.GONE);
        assertThat(fleet.visits).doesNotContainKey("beside");
        fleet.vehicle(1).falling = true;
        fleet.flyToTheEnd();

        assertThat(fleet.visits).containsKey("beside");
        assertThat(fleet.said)
                .anyMatch(said -> said.contains("The place where Drone d1 was last heard is free."))
                .anyMatch(said -> said.contains("it may still hover where it was heard last, until "));
    }

    /** Somebody may have stopped it a moment after it was heard last. */
    @Test
    void whatLiesJustAheadOfOneThatFlewIsLeftOutAsWell() {
        RunTestBench fleet = RunFixtures.fleet(3, 18, 1, MissionCloudLossPolicy.RETURN_TO_LAUNCH);
        fleet.flyUntil(
                () -> fleet.state.count(RunWaypoint.State.VISITED) >= 3
                        && fleet.vehicle(1).fliesMission(),
                600);
        TestVehicle silent = fleet.vehicle(1);
        double east = silent.east;
        double north = silent.north;
        fleet.fly(1.5);
        double way = Math.hypot(silent.east - east, silent.north - north);
        assertThat(way).as("it is on its way").isGreaterThan(10);
        Waypoint ahead = Waypoint.at(
                "ahead",
                PlanningFixtures.place(
                        silent.east + (silent.east - east) / way * 20 + 4,
                        silent.north + (silent.north - north) / way * 20,
                        silent.altitude));
        silent.withoutFailSafe = true;
        silent.cut = true;
        fleet.fly(2);
        silent.mode = "BRAKE";
        fleet.flyUntil(() -> fleet.drone(1).stage() == RunDroneStage.SILENT, 10);
        fleet.wish(new RunInput.AddWaypoints(fleet.now, "Ann", List.of(ahead)));
        fleet.fly(40);
        assertThat(fleet.state.target("ahead").orElseThrow().reason()).contains("was last heard there");
        fleet.fly(20);
        silent.cut = false;
        fleet.flyUntil(() -> fleet.drone(1).stage() == RunDroneStage.SUSPENDED, 20);
        fleet.wish(new RunInput.ResumeDrone(fleet.now, "Ann", silent.id));
        fleet.flyToTheEnd();

        assertThat(fleet.visits).containsKey("ahead");
        assertThat(fleet.closest).as("%s; %s", fleet.where, fleet.said).isGreaterThanOrEqualTo(10);
    }
}
