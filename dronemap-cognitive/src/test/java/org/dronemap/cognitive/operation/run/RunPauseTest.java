package org.dronemap.cognitive.operation.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunObjection;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.operation.Objection;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A run waits as a whole, and goes on as a whole. */
class RunPauseTest {
    private static RunTestBench flying(long seed) {
        RunTestBench fleet = RunFixtures.fleet(4, 24, seed, MissionCloudLossPolicy.RETURN_TO_LAUNCH);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
        return fleet;
    }

    private static void pause(RunTestBench fleet) {
        fleet.wish(new RunInput.Pause(fleet.now, "Ann"));
    }

    private static void goOn(RunTestBench fleet) {
        fleet.wish(new RunInput.Resume(fleet.now, "Ann"));
    }

    /** All are apart all along, and every waypoint is visited. */
    private static void goesOnToTheEnd(RunTestBench fleet) {
        goOn(fleet);
        fleet.flyToTheEnd();
        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(24);
        assertThat(fleet.closest).as("%s; %s", fleet.where, fleet.said).isGreaterThanOrEqualTo(10);
    }

    private static List<Double> places(RunTestBench fleet) {
        List<Double> places = new ArrayList<>();
        fleet.vehicles
                .values()
                .forEach(vehicle -> places.addAll(List.of(vehicle.east, vehicle.north, vehicle.altitude)));
        return places;
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void allHoldWhereTheyAreAndVisitTheRestAfterwards(long seed) {
        RunTestBench fleet = flying(seed);
        pause(fleet);
        fleet.fly(40);
        List<Double> held = places(fleet);
        fleet.fly(300);

        assertThat(places(fleet)).as("%s", fleet.said).isEqualTo(held);
        goesOnToTheEnd(fleet);
    }

    @Test
    void nobodyIsCalledHomeForHavingStoodInAPause() {
        RunTestBench fleet = flying(1);
        fleet.vehicles.values().forEach(vehicle -> vehicle.hesitates = 1);
        pause(fleet);
        fleet.fly(120);
        goesOnToTheEnd(fleet);

        assertThat(fleet.said).noneMatch(words -> words.contains("called home"));
    }

    @Test
    void nobodyIsArmedWhileItIsPaused() {
        RunTestBench fleet = RunFixtures.fleet(4, 24, 1);
        fleet.fly(1);
        pause(fleet);
        fleet.fly(120);

        assertThat(fleet.vehicles.values()).noneMatch(vehicle -> vehicle.armed);
        goesOnToTheEnd(fleet);
    }

    @ParameterizedTest
    @ValueSource(doubles = {2, 3, 4, 6, 9, 12})
    void whoeverWasAboutToSetOffIsApartFromTheOthersAfterwardsToo(double seconds) {
        RunTestBench fleet = RunFixtures.fleet(4, 24, 2);
        fleet.fly(seconds);
        pause(fleet);
        fleet.fly(60);
        goesOnToTheEnd(fleet);
    }

    @Test
    void aRestartDoesNotEndThePause() {
        RunTestBench fleet = flying(1);
        pause(fleet);
        fleet.fly(10);
        fleet.restart(3);
        fleet.fly(60);

        assertThat(fleet.state.clock().pausedSince()).isNotNull();
        assertThat(fleet.vehicles.values()).noneMatch(vehicle -> vehicle.mode.equals("AUTO"));
        goesOnToTheEnd(fleet);
    }

    @Test
    void whatALostDroneLeavesIsSharedOutAfterThePause() {
        RunTestBench fleet = flying(1);
        pause(fleet);
        fleet.fly(5);
        fleet.vehicle(1).falling = true;
        fleet.fly(30);

        assertThat(fleet.state.request()).isNull();
        assertThat(fleet.vehicles.values()).noneMatch(vehicle -> vehicle.mode.equals("AUTO") && !vehicle.fallen);
        goesOnToTheEnd(fleet);
    }

    @Test
    void whoseBatteryDoesNotLastForWaitingComesHome() {
        RunTestBench fleet = RunFixtures.limited(3, 12, 1);
        fleet.flyUntil(() -> fleet.state.count(RunWaypoint.State.VISITED) >= 3, 600);
        pause(fleet);
        fleet.vehicle(1).drain = 60;
        fleet.flyUntil(() -> fleet.drone(1).stage() == RunDroneStage.RETURNING, 900);

        fleet.flyUntil(() -> !fleet.vehicle(1).armed, 600);
        assertThat(fleet.vehicle(1).joules).isPositive();
        goOn(fleet);
        fleet.flyToTheEnd();
    }

    @Test
    void aPausedRunCanBeStopped() {
        RunTestBench fleet = flying(1);
        pause(fleet);
        fleet.fly(10);
        fleet.wish(new RunInput.Stop(fleet.now, "Ann"));
        fleet.flyToTheEnd();

        assertThat(fleet.vehicles.values()).noneMatch(vehicle -> vehicle.armed);
    }

    @Test
    void refusesToPauseTwiceAndToGoOnUnpaused() {
        RunTestBench fleet = flying(1);
        MissionRunOperation run = fleet.run;

        assertThat(run.refusal(fleet.state, new RunInput.Resume(fleet.now, "Ann")))
                .contains(Objection.of(RunObjection.NOT_PAUSED, "The mission run is not paused."));
        pause(fleet);
        assertThat(run.refusal(fleet.state, new RunInput.Pause(fleet.now, "Ann")))
                .contains(Objection.of(RunObjection.PAUSED, "The mission run is paused already."));
    }
}
