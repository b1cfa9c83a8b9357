package org.dronemap.cognitive.operation.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.Optional;
import java.util.function.Predicate;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** A drone that cannot be armed yet when a run begins is waited for, and leaves with the reason that it gave. */
class LateReadinessTest {
    private static Outcome refused(String words, OutcomeCode code) {
        return new Outcome.Refused("vehicle", words, code);
    }

    /** The vehicles with those numbers say no to such commands as long as the run is younger than that. */
    private static void refuse(
            RunTestBench fleet, Predicate<String> drones, Predicate<Command> commands, double seconds, Outcome no) {
        fleet.refuses = give -> drones.test(give.drone().value())
                        && commands.test(give.command())
                        && Duration.between(RunTestBench.START, fleet.now).toMillis() < 1000 * seconds
                ? Optional.of(no)
                : Optional.empty();
    }

    @Test
    void dronesWithoutAPositionEstimateAreTriedAgainUntilTheyFly() {
        RunTestBench fleet = RunFixtures.fleet(4, 24, 3);
        Outcome no = refused("Mode change to GUIDED failed: requires position", OutcomeCode.VEHICLE_FAILED);
        refuse(fleet, id -> !id.equals("d0"), Command.SetMode.class::isInstance, 45, no);
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(24);
        assertThat(fleet.state.drones()).noneMatch(drone -> drone.stage() == RunDroneStage.LEFT);
        assertThat(fleet.visits.values().stream().flatMap(by -> by.stream()).distinct())
                .hasSize(4);
        assertThat(fleet.state.explanations())
                .filteredOn(said -> said.words().contains("requires position"))
                .as("once of each")
                .hasSize(3)
                .allSatisfy(said -> assertThat(said.words()).contains("cannot be armed yet", "120 s"));
    }

    @ParameterizedTest
    @EnumSource(
            value = OutcomeCode.class,
            names = {"VEHICLE_BUSY", "VEHICLE_FAILED", "VEHICLE_DENIED", "COMMAND_UNDER_WAY"})
    void aRefusedArmingThatCanPassIsTriedAgain(OutcomeCode code) {
        RunTestBench fleet = RunFixtures.fleet(2, 8, 1);
        refuse(fleet, id -> true, Command.Arm.class::isInstance, 60, refused("PreArm: Need Position Estimate.", code));
        fleet.flyToTheEnd();

        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(8);
        assertThat(fleet.state.drones()).noneMatch(drone -> drone.stage() == RunDroneStage.LEFT);
    }

    @Test
    void oneThatStaysRefusedLeavesAfterTheStatedPatienceWithItsReasonAndTheOthersDoItsPart() {
        RunTestBench fleet = RunFixtures.fleet(3, 12, 2);
        Outcome no = refused("PreArm: Compass not calibrated", OutcomeCode.VEHICLE_FAILED);
        refuse(fleet, "d1"::equals, Command.Arm.class::isInstance, 9_999, no);
        fleet.flyUntil(() -> fleet.drone(1).stage() == RunDroneStage.ARMING, 60);
        fleet.fly(100);
        assertThat(fleet.drone(1).stage()).isEqualTo(RunDroneStage.ARMING);
        assertThat(fleet.drone(1).note()).contains("PreArm: Compass not calibrated", "tried again");

        fleet.flyToTheEnd();
        assertThat(fleet.drone(1).stage()).isEqualTo(RunDroneStage.LEFT);
        assertThat(fleet.drone(1).note()).contains("could not be armed for 120 s", "PreArm: Compass not calibrated");
        assertThat(fleet.state.count(RunWaypoint.State.VISITED)).isEqualTo(12);
    }

    @Test
    void whatIsSaidOfADroneThatFliesAfterAllIsNotItsOldTrouble() {
        RunTestBench fleet = RunFixtures.fleet(2, 8, 1);
        Outcome no = refused("Need Position Estimate", OutcomeCode.VEHICLE_FAILED);
        refuse(fleet, "d1"::equals, Command.Arm.class::isInstance, 20, no);
        fleet.flyUntil(() -> fleet.drone(1).stage() == RunDroneStage.FLYING, 120);

        assertThat(fleet.drone(1).note()).isNull();
    }

    @Test
    void aPauseWhileADroneIsWaitedForDoesNotUseUpThePatience() {
        RunTestBench fleet = RunFixtures.fleet(2, 8, 1);
        Outcome no = refused("Need Position Estimate", OutcomeCode.VEHICLE_FAILED);
        refuse(fleet, "d1"::equals, Command.Arm.class::isInstance, 330, no);
        fleet.flyUntil(() -> fleet.drone(1).stage() == RunDroneStage.ARMING, 60);
        fleet.fly(20);
        fleet.wish(new RunInput.Pause(fleet.now, "Ann"));
        fleet.fly(300);
        fleet.wish(new RunInput.Resume(fleet.now, "Ann"));
        fleet.flyToTheEnd();

        assertThat(fleet.drone(1).stage()).isEqualTo(RunDroneStage.LANDED);
    }

    @Test
    void aDroneThatTheGateWillNeverLetArmIsNotWaitedFor() {
        RunTestBench fleet = RunFixtures.fleet(2, 8, 1);
        Outcome no = new Outcome.Refused("gate", "This vehicle cannot be armed.", OutcomeCode.CAPABILITY_MISSING);
        refuse(fleet, "d1"::equals, Command.Arm.class::isInstance, 9_999, no);
        fleet.flyUntil(() -> fleet.drone(1).stage() == RunDroneStage.LEFT, 30);

        assertThat(fleet.drone(1).note()).contains("This vehicle cannot be armed");
    }
}
