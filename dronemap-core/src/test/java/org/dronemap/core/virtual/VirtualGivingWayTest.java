package org.dronemap.core.virtual;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.separation.GiveWay;
import org.dronemap.core.virtual.VirtualFixtures.Drone;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The mission of a virtual drone whose real one gives way to others. */
class VirtualGivingWayTest {
    private final VirtualRunMachine machine = new VirtualRunMachine(Duration.ofSeconds(60));
    private final Drone drone = new Drone("d1", 100);
    private VirtualRun run = VirtualFixtures.bound(3, "d1");
    private Instant now = VirtualFixtures.NOW;
    private @Nullable GiveWay giveWay;
    private Duration still = Duration.ZERO;

    private static GiveWay give(GiveWay.Manner manner, boolean clear) {
        return new GiveWay(new DroneId("d9"), "Copter d9", manner, VirtualFixtures.NOW, clear, null);
    }

    private @Nullable Command step(@Nullable Outcome outcome) {
        VirtualRunStep step = machine.next(
                run,
                new VirtualRunObservation(
                        drone.state(), null, outcome, false, Duration.ZERO, still, true, giveWay, now));
        run = step.send() == null ? step.run() : step.run().given(new CommandId("command-1"), now);
        return step.send();
    }

    @Test
    void isNotArmedWhileAnotherOneIsInItsWay() {
        assertThat(step(null)).isInstanceOf(Command.UploadMission.class);
        step(new Outcome.Succeeded());
        giveWay = give(GiveWay.Manner.WAIT, false);
        assertThat(step(null)).isNull();
        assertThat(run.note()).contains("waits on the ground");
        giveWay = null;
        now = now.plusSeconds(1);
        assertThat(step(null)).isInstanceOf(Command.Arm.class);
    }

    /** Its battery is not for waiting for one that hovers on its way for ever. */
    @Test
    void comesHomeWhenTheOtherOneDoesNotLeaveItsWay() {
        fly();
        drone.mode = "GUIDED";
        giveWay = give(GiveWay.Manner.STOP, false);
        step(null);
        now = now.plusSeconds(170);
        step(null);
        assertThat(run.stage()).isEqualTo(VirtualRunStage.FLYING);
        now = now.plusSeconds(20);
        step(null);
        assertThat(run.stage()).isEqualTo(VirtualRunStage.GIVING_UP);
        assertThat(run.note()).contains("does not leave the way");
    }

    private void fly() {
        step(null);
        step(new Outcome.Succeeded());
        drone.flies().carries(run.tour().share(0, 20.0), 2, 0, 1);
        step(null);
        step(null);
        step(null);
        assertThat(run.stage()).isEqualTo(VirtualRunStage.FLYING);
    }

    /** Else it would be called home, as one that left its mission. */
    @Test
    void waitsWhileItsDroneGivesWayAndSendsItOnAfterwards() {
        fly();
        drone.mode = "GUIDED";
        giveWay = give(GiveWay.Manner.STOP, false);
        assertThat(step(null)).isNull();
        assertThat(run.stage()).isEqualTo(VirtualRunStage.FLYING);
        assertThat(run.note()).contains("waits until another one has passed");
        giveWay = give(GiveWay.Manner.STOP, true);
        now = now.plusSeconds(10);
        assertThat(step(null)).isEqualTo(new Command.StartMission(run.onCloudLoss()));
        drone.mode = "AUTO";
        giveWay = null;
        step(new Outcome.Succeeded());
        assertThat(run.note()).isEqualTo("The drone flies the mission.");
    }

    /** It stood for as long as it had to. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void isNotStuckWhenItGoesOnAfterALongWait(boolean shownFirst) {
        fly();
        drone.mode = "GUIDED";
        giveWay = give(GiveWay.Manner.STOP, false);
        step(null);
        now = now.plusSeconds(100);
        still = Duration.ofSeconds(100);
        drone.mode = "AUTO";
        giveWay = shownFirst ? give(GiveWay.Manner.STOP, true) : null;
        step(new Outcome.Succeeded());
        step(null);
        giveWay = null;
        step(null);
        assertThat(run.stage()).isEqualTo(VirtualRunStage.FLYING);

        now = now.plusSeconds(31);
        still = Duration.ofSeconds(131);
        step(null);
        assertThat(run.stage()).isEqualTo(VirtualRunStage.GIVING_UP);
    }
}
