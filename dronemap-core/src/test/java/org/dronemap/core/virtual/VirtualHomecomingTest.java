package org.dronemap.core.virtual;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.virtual.VirtualFixtures.Drone;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** A virtual drone's run ends in the way of its drone's kind, and says what is true of that. */
class VirtualHomecomingTest {
    private static final CommandId ID = new CommandId("command-1");

    private final VirtualRunMachine machine = new VirtualRunMachine(Duration.ofSeconds(60));
    private final Drone drone = new Drone("d1", 100);
    private VirtualRun run = VirtualFixtures.bound(3, "d1");
    private final Instant now = VirtualFixtures.NOW;
    private Duration still = Duration.ZERO;

    /** It would drift away without its motors. */
    @Test
    void leavesABoatAtHomeArmedAndSaysSo() {
        drone.kind = VehicleKind.BOAT;
        returning();
        still = Duration.ofSeconds(3);

        assertThat(step(null).release()).isEqualTo(VirtualRunStep.Release.FREE);
        assertThat(run.stage()).isEqualTo(VirtualRunStage.DONE);
        assertThat(run.note())
                .isEqualTo("Done: all waypoints are flown. The drone holds its place at home, armed. Nobody controls it"
                        + " now.");
    }

    @Test
    void disarmsARoverOnceAtHomeAndAgainOnlyAfterAWhile() {
        drone.kind = VehicleKind.ROVER;
        returning();
        assertThat(sent(null)).isNull();
        still = Duration.ofSeconds(3);

        assertThat(sent(null)).isEqualTo(new Command.Disarm(false));
        assertThat(sent(null)).isNull();
    }

    @Test
    void saysOfARoverNeitherThatItFliesNorThatItCameDown() {
        drone.kind = VehicleKind.ROVER;
        driving();
        drone.link = LinkState.LOST;
        quiet(Duration.ofSeconds(1));
        assertThat(run.note()).contains("it may still be under way");
        drone.link = LinkState.LIVE;
        drone.armed = false;
        step(null);

        assertThat(run.note()).startsWith("The drone was disarmed before the end.");
    }

    /** Its pilot may have, or a fail-safe. */
    @Test
    void namesNobodyForAWayHomeThatTheMissionDidNotAskFor() {
        driving();
        drone.mode = "RTL";
        step(null);

        assertThat(run.note()).startsWith("The drone went home or down (RTL), which its mission did not ask for.");
    }

    private void driving() {
        run = VirtualFixtures.asked(3).bound(VirtualFixtures.choiceOf("d1"), null, now);
        VirtualTourSection driven = run.tour().share(0, null);
        sent(null);
        sent(new Outcome.Succeeded());
        drone.armed = true;
        sent(new Outcome.Succeeded());
        drone.flies().carries(driven, 0);
        sent(new Outcome.Succeeded());
        assertThat(run.stage()).isEqualTo(VirtualRunStage.FLYING);
    }

    private void returning() {
        driving();
        drone.carries(run.tour().share(0, null), 3, 0, 1, 2);
        sent(null);
        assertThat(run.stage()).isEqualTo(VirtualRunStage.RETURNING);
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
        return new VirtualRunObservation(drone.state(), takenBy, outcome, false, silence, still, mayFly, null, now);
    }
}
