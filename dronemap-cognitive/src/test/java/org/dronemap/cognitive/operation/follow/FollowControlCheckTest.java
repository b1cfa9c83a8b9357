package org.dronemap.cognitive.operation.follow;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import org.dronemap.cognitive.operation.follow.FollowInput.Observation;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.SetReturnOnCloudLoss;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.IdentityTrust;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.LinkStatus;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.drone.PayloadState;
import org.dronemap.core.drone.VehicleKind;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** No drone is left with nobody who looks after it, nor taken from whoever does. */
class FollowControlCheckTest extends FollowTestBase {
    @Test
    void bringsHomeADroneThatNobodyHasAnyMore() {
        start();
        seen(led(new Observation(
                "The supervisor has it.", 0, true, true, true, false, "GUIDED", 90, 300.0, null, null)));
        Observation adrift = air(new FollowInput.ControlRestriction(null, true, false));
        silent(adrift, 50);
        assertThat(state.note()).contains("Nobody has Falcon any more", "after 60 s");
        silent(AIR, 1);
        assertThat(state.note()).isNull();
        silent(adrift, 59);
        assertThat(state.stage()).isEqualTo(FollowStage.SUSPENDED);
        silent(adrift, 2);
        assertThat(state.stage()).isEqualTo(FollowStage.RETURNING);
        assertThat(follow.drones(state)).containsExactly(state.drone());
    }

    @Test
    void bringsItHomeWhenWhoeverAskedMayNotCommandItAnyMore() {
        start();
        Observation barred = air(new FollowInput.ControlRestriction("mia may not command it any more.", false, false));
        seen(barred);
        seen(barred);
        assertThat(given).last().isEqualTo(new Command.ReturnToLaunch());
        assertThat(state.notices())
                .last()
                .extracting(FollowState.Notice::words)
                .isEqualTo("mia may not command it any more. Falcon flies home.");
    }

    @Test
    void followsAgainWhenItsDroneMissedTheCloudAndThePhoneSpeaks() {
        start();
        heard(AIR, 5);
        now += 20;
        take(new FollowInput.Restarted(at()));
        silent(HOMING, 5);
        assertThat(state.stage()).isEqualTo(FollowStage.TRACKING);
        assertThat(state.note()).contains("missed the cloud");
        heard(HOMING, 0.1);
        assertThat(state.stage()).isEqualTo(FollowStage.STARTING);
        seen(HOMING);
        assertThat(given).last().isEqualTo(new Command.SetMode("GUIDED"));
        succeeds();
        heard(AIR, 1);
        // Later it has other reasons.
        seen(HOMING);
        assertThat(state.stage()).isEqualTo(FollowStage.RETURNING);
    }

    @Test
    void letsItsDroneComeHomeThatMissedTheCloudWhenThePhoneIsSilent() {
        start();
        now += 20;
        take(new FollowInput.Restarted(at()));
        silent(HOMING, 59);
        assertThat(state.stage()).isEqualTo(FollowStage.TRACKING);
        silent(HOMING, 2);
        assertThat(state.stage()).isEqualTo(FollowStage.RETURNING);
        assertThat(given).hasSize(4);
    }

    @Test
    void leavesItsDroneToThePilotWhomItFindsAfterARestart() {
        start();
        Observation piloted = new Observation(
                null,
                0,
                true,
                true,
                false,
                false,
                "LOITER",
                90,
                300.0,
                new FollowInput.ControlRestriction(null, false, true),
                null);
        take(new FollowInput.Stop(at(), "mia"));
        now += 20;
        take(new FollowInput.Restarted(at()));
        silent(piloted, 5);
        assertThat(state.stage()).isEqualTo(FollowStage.SUSPENDED);
        assertThat(given).hasSize(4);
    }

    @Test
    void startsNoMotorsLongAfterSomebodyPressedTheButton() {
        take(new FollowInput.Start(at(), "mia"));
        now += 59;
        take(new FollowInput.Restarted(at()));
        assertThat(state.stage()).isEqualTo(FollowStage.STARTING);
        now += 2;
        take(new FollowInput.Restarted(at()));
        seen(GROUND);
        assertThat(state.isOver()).isTrue();
        assertThat(given).isEmpty();
    }

    @Test
    void saysThatADroneWouldStayWhereItIsWithoutTheCloud() {
        take(new FollowInput.Start(at(), "mia"));
        seen(GROUND);
        ends(new Outcome.TimedOut("The vehicle did not tell its parameter FS_GCS_ENABLE."));
        seen(GROUND);
        assertThat(given).containsExactly(new SetReturnOnCloudLoss(), new Command.Arm());
        assertThat(state.notices())
                .last()
                .extracting(FollowState.Notice::words)
                .asString()
                .contains("FS_GCS_ENABLE", "would then stay where it is");
    }

    @Test
    void decidesNothingOnADroneThatHasNotCalledInYet() {
        assertThat(FollowControlCheck.silentSeconds(drone(LinkState.LOST, true), Duration.ZERO))
                .isPositive();
        assertThat(FollowControlCheck.silentSeconds(drone(LinkState.LIVE, null), Duration.ZERO))
                .isPositive();
        assertThat(FollowControlCheck.silentSeconds(drone(LinkState.LIVE, true), Duration.ZERO))
                .isZero();
        start();
        Observation unheard = led(new Observation(null, 1, false, false, false, false, null, null, null, null, null));
        take(new FollowInput.Restarted(at()));
        silent(unheard, 20);
        assertThat(state.stage()).isEqualTo(FollowStage.TRACKING);
    }

    private static DroneState drone(LinkState link, @Nullable Boolean armed) {
        return new DroneState(
                new DroneId("d1"),
                "Falcon",
                false,
                new LinkStatus(new DroneKey("127.0.0.1", 1, 1), "udp", link, ZERO, LinkQuality.UNKNOWN, List.of()),
                new Identification(VehicleKind.MULTICOPTER, "ArduPilot", "ArduCopter", null, null),
                IdentityTrust.UNPROVED,
                Capabilities.NONE,
                "GUIDED",
                armed,
                null,
                FlightPhase.IN_AIR,
                null,
                null,
                null,
                null,
                null,
                null,
                null,
                null,
                PayloadState.UNKNOWN,
                MissionProgress.UNKNOWN,
                List.of(),
                ZERO,
                0,
                null);
    }
}
