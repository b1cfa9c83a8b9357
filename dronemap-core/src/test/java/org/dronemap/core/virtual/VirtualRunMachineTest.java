package org.dronemap.core.virtual;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.MissionPhase;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.virtual.VirtualFixtures.Drone;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

class VirtualRunMachineTest {
    private static final Duration SILENCE = Duration.ofSeconds(60);
    private static final CommandId ID = new CommandId("command-1");

    private final VirtualRunMachine machine = new VirtualRunMachine(SILENCE);
    private final Drone drone = new Drone("d1", 100);
    private VirtualRun run = VirtualFixtures.bound(3, "d1");
    private Instant now = VirtualFixtures.NOW;
    private Duration still = Duration.ZERO;

    @Test
    void uploadsArmsStartsAndComesBack() {
        assertThat(sent(null)).isEqualTo(new Command.UploadMission(share().mission()));
        assertThat(sentWhenLookedAt()).isEqualTo(new Command.Arm());
        drone.armed = true;
        assertThat(sent(new Outcome.Succeeded())).isInstanceOf(Command.StartMission.class);
        drone.flies().carries(share(), 0);
        assertThat(sent(new Outcome.Succeeded())).isNull();
        assertThat(run.stage()).isEqualTo(VirtualRunStage.FLYING);

        drone.carries(share(), 2, 0, 1);
        sent(null);
        assertThat(run.flown()).isEqualTo(1);
        drone.carries(share(), 4, 0, 1, 2, 3);
        sent(null);
        assertThat(run.flown()).isEqualTo(3);
        assertThat(run.stage()).isEqualTo(VirtualRunStage.RETURNING);

        drone.armed = false;
        drone.airborne = false;
        assertThat(step(null).release()).isEqualTo(VirtualRunStep.Release.FREE);
        assertThat(run.stage()).isEqualTo(VirtualRunStage.DONE);
    }

    @Test
    void changesToAModeInWhichItCanBeArmedFirst() {
        drone.mode = "RTL";
        sent(null);
        assertThat(sentWhenLookedAt()).isEqualTo(new Command.SetMode("GUIDED"));
        drone.mode = "GUIDED";
        assertThat(sent(new Outcome.Succeeded())).isEqualTo(new Command.Arm());
    }

    @Test
    void triesThreeTimesAndThenLeavesItToAnother() {
        sent(null);
        assertThat(sent(new Outcome.TimedOut("no answer"))).isInstanceOf(Command.UploadMission.class);
        assertThat(sent(new Outcome.TimedOut("no answer"))).isInstanceOf(Command.UploadMission.class);
        VirtualRunStep last = step(new Outcome.Refused("vehicle", "no room", OutcomeCode.VEHICLE_REFUSED));

        assertThat(last.release()).isEqualTo(VirtualRunStep.Release.FREE);
        assertThat(run.stage()).isEqualTo(VirtualRunStage.QUEUED);
        assertThat(run.detail()).isEqualTo("no room");
        assertThat(VirtualRunMachine.avoids(run, drone.state(), now)).isTrue();
        assertThat(VirtualRunMachine.avoids(run, drone.state(), now.plusSeconds(3_600)))
                .isFalse();
    }

    @Test
    void waitsForADroneThatCannotBeArmedYet() {
        sent(null);
        sent(new Outcome.Succeeded());
        Outcome refused = new Outcome.Refused("vehicle", "Need Position Estimate", OutcomeCode.VEHICLE_FAILED);
        boolean asked = true;
        int tries = 0;
        for (int second = 0; second < 100; second++) {
            asked = sent(asked ? refused : null) != null;
            tries += asked ? 1 : 0;
            now = now.plusSeconds(1);
        }

        assertThat(tries).isBetween(20, 40);
        assertThat(run.stage()).isEqualTo(VirtualRunStage.ARMING);
        assertThat(run.note()).contains("cannot be armed yet", "120 s");
        assertThat(run.detail()).isEqualTo("Need Position Estimate");
        drone.armed = true;
        sent(new Outcome.Succeeded());
        assertThat(run.stage()).isEqualTo(VirtualRunStage.STARTING);
        assertThat(run.detail()).isNull();
    }

    @Test
    void leavesADroneThatCouldNotBeArmedForTwoMinutesToAnother() {
        sent(null);
        sent(new Outcome.Succeeded());
        Outcome refused = new Outcome.Refused("vehicle", "Compass not calibrated", OutcomeCode.VEHICLE_FAILED);
        sent(refused);
        now = now.plusSeconds(130);
        sent(refused);
        sent(refused);
        VirtualRunStep last = step(refused);

        assertThat(last.release()).isEqualTo(VirtualRunStep.Release.FREE);
        assertThat(run.stage()).isEqualTo(VirtualRunStage.QUEUED);
        assertThat(run.detail()).isEqualTo("Compass not calibrated");
    }

    @Test
    void leavesTheRestToAnotherWhenTheDroneComesDown() {
        flyTo(2);
        drone.armed = false;
        drone.airborne = false;
        step(null);

        assertThat(run.stage()).isEqualTo(VirtualRunStage.QUEUED);
        assertThat(run.flown()).isEqualTo(1);
        assertThat(run.assignment()).isNull();
        VirtualTourSection rest = run.tour().share(run.flown(), 20.0);
        assertThat(rest.mission().items()).hasSize(4);
    }

    @Test
    void leavesTheRestToAnotherWhenTheDroneGoesHomeByItself() {
        flyTo(2);
        drone.mode = "RTL";

        assertThat(step(null).release()).isEqualTo(VirtualRunStep.Release.FREE);
        assertThat(run.stage()).isEqualTo(VirtualRunStage.QUEUED);
    }

    @Test
    void keepsTheWaypointsOfASilentDroneUntilItMustBeDown() {
        flyTo(2);
        drone.link = LinkState.LOST;

        assertThat(quiet(Duration.ofSeconds(70)).release()).isEqualTo(VirtualRunStep.Release.KEEP);
        assertThat(run.assignment()).isNotNull();
        assertThat(run.note()).contains("may still fly");

        assertThat(quiet(Duration.ofMinutes(10)).release()).isEqualTo(VirtualRunStep.Release.RECALL);
        assertThat(run.stage()).isEqualTo(VirtualRunStage.QUEUED);
    }

    @Test
    void goesOnWithADroneThatIsHeardAgainInTime() {
        flyTo(2);
        drone.link = LinkState.LOST;
        quiet(Duration.ofSeconds(30));
        drone.link = LinkState.LIVE;
        drone.carries(share(), 3, 0, 1, 2);
        step(null);

        assertThat(run.stage()).isEqualTo(VirtualRunStage.FLYING);
        assertThat(run.flown()).isEqualTo(2);
    }

    @Test
    void goesOnAfterARestartWhereverItWas() {
        flyTo(2);
        // Nothing is known of the drone yet.
        drone.mission = MissionProgress.UNKNOWN;
        drone.armed = false;
        assertThat(step(null).run().stage()).isEqualTo(VirtualRunStage.FLYING);

        drone.airborne = false;
        drone.carries(share(), 4, 0, 1, 2, 3, 4);
        step(null);
        step(null);
        assertThat(run.stage()).isEqualTo(VirtualRunStage.DONE);
    }

    @Test
    void isDoneWhenTheDroneFlewAllAndCameBackDuringARestart() {
        flyTo(2);
        drone.armed = false;
        drone.airborne = false;
        // The vehicle names no item any more, and nobody heard which ones it reached.
        drone.mission =
                new MissionProgress(share().mission().items(), null, null, MissionPhase.COMPLETE, List.of(), null);
        step(null);
        assertThat(run.flown()).isEqualTo(run.total());
        step(null);

        assertThat(run.stage()).isEqualTo(VirtualRunStage.DONE);
    }

    @Test
    void armsNoSecondTimeWhatIsArmedAfterARestart() {
        sent(null);
        step(new Outcome.Succeeded());
        drone.armed = true;
        Outcome lost = new Outcome.Unknown("The server restarted while it was under way.");

        assertThat(sent(lost)).isInstanceOf(Command.StartMission.class);
    }

    @Test
    void armsAgainWhatWasDisarmedBeforeItStarted() {
        getReadyToStart();
        drone.armed = false;
        assertThat(sentWhenLookedAt()).isEqualTo(new Command.Arm());
        assertThat(run.stage()).isEqualTo(VirtualRunStage.ARMING);
        assertThat(run.note()).isEqualTo("It was disarmed before it started.");
        drone.armed = true;
        assertThat(sent(new Outcome.Succeeded())).isInstanceOf(Command.StartMission.class);
    }

    @Test
    void leavesToAnotherWhatIsDisarmedAgainAndAgainBeforeItStarts() {
        getReadyToStart();
        for (int time = 1; time < 3; time++) {
            drone.armed = false;
            assertThat(sentWhenLookedAt()).isEqualTo(new Command.Arm());
            drone.armed = true;
            assertThat(sent(new Outcome.Succeeded())).isInstanceOf(Command.StartMission.class);
        }
        drone.armed = false;

        assertThat(step(new Outcome.Succeeded()).release()).isEqualTo(VirtualRunStep.Release.FREE);
        assertThat(run.stage()).isEqualTo(VirtualRunStage.QUEUED);
        assertThat(run.detail()).isEqualTo("It was disarmed before it started.");
        assertThat(VirtualRunMachine.avoids(run, drone.state(), now)).isTrue();
    }

    @Test
    void waitsForItsUserOnceSomebodyWhoGoesFirstHasTheDrone() {
        flyTo(2);
        VirtualRunStep step =
                machine.next(run, sight(null, "The pilot at the vehicle has control.", Duration.ZERO, true));

        assertThat(step.run().stage()).isEqualTo(VirtualRunStage.SUSPENDED);
        VirtualRun resumed = machine.resume(step.run(), now).orElseThrow();
        assertThat(resumed.stage()).isEqualTo(VirtualRunStage.QUEUED);
        assertThat(resumed.flown()).isEqualTo(1);
    }

    /** Also before anybody has said that its pilot has control. */
    @Test
    void callsNoDroneHomeThatSomebodySteersByHand() {
        flyTo(2);
        drone.mode = "STABILIZE";
        VirtualRunStep step = machine.next(run, sight(null, null, Duration.ZERO, true));

        assertThat(step.run().stage()).isEqualTo(VirtualRunStage.SUSPENDED);
        assertThat(step.send()).isNull();
        assertThat(step.release()).isEqualTo(VirtualRunStep.Release.FREE);
    }

    @Test
    void bringsTheDroneHomeWhenItIsStopped() {
        flyTo(2);
        run = machine.stop(run, now);

        assertThat(sent(null)).isEqualTo(new Command.ReturnToLaunch());
        assertThat(sent(new Outcome.Succeeded())).isNull();
        drone.mode = "RTL";
        now = now.plusSeconds(30);
        assertThat(sent(null)).isNull();
        drone.armed = false;
        step(null);
        assertThat(run.stage()).isEqualTo(VirtualRunStage.STOPPED);
    }

    @Test
    void stopsWhenItsOwnerMayFlyNoMore() {
        flyTo(2);
        VirtualRunStep step = machine.next(run, sight(null, null, Duration.ZERO, false));

        assertThat(step.run().stage()).isEqualTo(VirtualRunStage.STOPPING);
    }

    @Test
    void callsADroneHomeThatCarriesAnotherMission() {
        flyTo(2);
        drone.mission = new MissionProgress(
                VirtualFixtures.mission(2).items(), null, 0, MissionPhase.RUNNING, java.util.List.of(), null);

        assertThat(sent(null)).isEqualTo(new Command.ReturnToLaunch());
        assertThat(run.stage()).isEqualTo(VirtualRunStage.GIVING_UP);
    }

    @Test
    void takesADroneThatDoesNotMoveOnForFallen() {
        flyTo(2);
        still = Duration.ofSeconds(25);
        assertThat(sent(null)).isNull();

        still = Duration.ofSeconds(35);
        assertThat(sent(null)).isEqualTo(new Command.ReturnToLaunch());
        drone.mode = "RTL";
        assertThat(step(new Outcome.Succeeded()).release()).isEqualTo(VirtualRunStep.Release.FREE);
        assertThat(run.stage()).isEqualTo(VirtualRunStage.QUEUED);
    }

    @Test
    void aDroneThatHasJustWaitedAtAWaypointMovesOn() {
        run = VirtualRun.asked(
                        VirtualFixtures.order(new Mission(List.of(
                                new MissionItem.Waypoint(VirtualFixtures.FIRST, Altitude.aboveHome(20), 60),
                                new MissionItem.Waypoint(VirtualFixtures.FIRST, Altitude.aboveHome(30), 0)))),
                        VirtualFixtures.NOW)
                .bound(VirtualFixtures.choiceOf("d1"), 20.0, VirtualFixtures.NOW);
        flyTo(2);
        assertThat(run.flown()).isEqualTo(1);
        still = Duration.ofSeconds(62);

        assertThat(sent(null)).isNull();
        assertThat(run.stage()).isEqualTo(VirtualRunStage.FLYING);
    }

    @Test
    void failsWhenDroneAfterDroneCannotGoOn() {
        for (int failure = 0; failure < 5; failure++) {
            assertThat(run.stage().isBound()).isTrue();
            step(new Outcome.Failed("no"));
            step(new Outcome.Failed("no"));
            step(new Outcome.Failed("no"));
            if (run.stage() == VirtualRunStage.QUEUED) {
                run = run.bound(VirtualFixtures.choiceOf("d1"), 20.0, now);
            }
        }
        assertThat(run.stage()).isEqualTo(VirtualRunStage.FAILED);
        assertThat(run.assignment()).isNull();
    }

    /** Armed, and told to start. */
    private void getReadyToStart() {
        sent(null);
        sent(new Outcome.Succeeded());
        drone.armed = true;
        assertThat(sent(new Outcome.Succeeded())).isInstanceOf(Command.StartMission.class);
    }

    /** In flight to that item of the vehicle's, everything before it reached. */
    private void flyTo(int item) {
        sent(null);
        step(new Outcome.Succeeded());
        drone.flies().carries(share(), item, 0, item - 1);
        step(null);
        step(null);
        step(null);
        assertThat(run.stage()).isEqualTo(VirtualRunStage.FLYING);
    }

    private VirtualTourSection share() {
        return run.tour().share(0, 20.0);
    }

    private @Nullable Command sent(@Nullable Outcome outcome) {
        Command command = step(outcome).send();
        Outcome seen = outcome;
        // As the conductor does: as long as something follows.
        for (int i = 0; command == null && i < 5; i++) {
            VirtualRun before = run;
            command = step(run.assignment() != null && run.assignment().command() == null ? null : seen)
                    .send();
            if (before.equals(run)) {
                break;
            }
        }
        return command;
    }

    /** Whether another drone is in its way is seen first. */
    private @Nullable Command sentWhenLookedAt() {
        assertThat(sent(new Outcome.Succeeded())).isNull();
        now = now.plusSeconds(1);
        return sent(null);
    }

    private VirtualRunStep step(@Nullable Outcome outcome) {
        return take(machine.next(run, sight(outcome, null, Duration.ZERO, true)));
    }

    private VirtualRunStep quiet(Duration silence) {
        return take(machine.next(run, sight(null, null, silence, true)));
    }

    private VirtualRunStep take(VirtualRunStep step) {
        run = step.send() == null ? step.run() : step.run().given(ID, now);
        return step;
    }

    private VirtualRunObservation sight(
            @Nullable Outcome outcome, @Nullable String takenBy, Duration silence, boolean mayFly) {
        return new VirtualRunObservation(
                drone.state(), takenBy, outcome, false, silence, still, mayFly, null, now.plus(still));
    }
}
