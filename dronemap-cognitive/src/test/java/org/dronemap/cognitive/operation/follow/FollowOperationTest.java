package org.dronemap.cognitive.operation.follow;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.dronemap.cognitive.operation.follow.FollowInput.Observation;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.SetReturnOnCloudLoss;
import org.dronemap.core.operation.ReporterState;
import org.junit.jupiter.api.Test;

/** From asking to be followed to the drone's being down again. */
class FollowOperationTest extends FollowTestBase {
    @Test
    void takesOffFollowsComesHomeAndIsOver() {
        start();
        assertThat(given)
                .containsExactly(
                        new SetReturnOnCloudLoss(),
                        new Command.SetMode("GUIDED"),
                        new Command.Arm(),
                        new Command.TakeOff(15));
        assertThat(state.stage()).isEqualTo(FollowStage.TRACKING);
        heard(AIR, 100);
        assertThat(state.stage()).isEqualTo(FollowStage.TRACKING);
        take(new FollowInput.Stop(at(), "mia"));
        seen(AIR);
        succeeds();
        silent(HOMING, 20);
        assertThat(given).hasSize(5).last().isEqualTo(new Command.ReturnToLaunch());
        assertThat(state.isOver()).isFalse();
        seen(GROUND);
        assertThat(state.isOver()).isTrue();
        assertThat(follow.drones(state)).isEmpty();
    }

    /** Each wish and event at each stage: what comes of it, or that it is not taken. */
    @Test
    void answersEachWishAndEventAtEachStageAsTheTableSays() throws IOException {
        Observation away = led(
                new Observation("The supervisor has it.", 0, true, true, true, false, "GUIDED", 90, 300.0, null, null));
        Observation barred = air(new FollowInput.ControlRestriction("mia may not command it any more.", false, false));
        Map<String, FollowInput> inputs = new LinkedHashMap<>();
        inputs.put("start", new FollowInput.Start(ZERO, "mia"));
        inputs.put("cancel", new FollowInput.Cancel(ZERO, "mia"));
        inputs.put("pause", new FollowInput.Pause(ZERO, "mia"));
        inputs.put("continue", new FollowInput.Resume(ZERO, "mia"));
        inputs.put("stop", new FollowInput.Stop(ZERO, "mia"));
        inputs.put("change", new FollowInput.ChangePlace(ZERO, "mia", BEHIND));
        inputs.put("taken", new FollowInput.Observed(ZERO, away, ZERO, null, null));
        inputs.put("revoked", new FollowInput.Observed(ZERO, barred, ZERO, null, null));
        inputs.put("removed", new FollowInput.Observed(ZERO, null, ZERO, null, null));
        inputs.put("restarted", new FollowInput.Restarted(ZERO));
        List<String> table = new ArrayList<>();
        inputs.forEach((name, input) -> {
            StringBuilder line = new StringBuilder("| " + name + " |");
            Arrays.stream(FollowStage.values())
                    .filter(stage -> stage != FollowStage.OVER)
                    .forEach(
                            stage -> line.append(' ').append(cell(stage, input)).append(" |"));
            table.add(line.toString());
        });
        assertThat(Files.readAllLines(Path.of("../docs/following.md"))).containsSubsequence(table);
    }

    private String cell(FollowStage stage, FollowInput input) {
        FollowState before = stage == FollowStage.ALLOCATED ? state : state.to(stage, ZERO, "so it was");
        FollowState next = follow.decide(before, input).next();
        if (follow.refusal(before, input).isPresent()) {
            assertThat(next).isEqualTo(before);
            return "no";
        }
        // Whoever took it has it; else the follow has, or it is over.
        boolean owned = next.stage() == FollowStage.SUSPENDED || next.isOver();
        assertThat(owned || follow.drones(next).contains(state.drone())).isTrue();
        return next.stage().name().toLowerCase(Locale.ROOT);
    }

    @Test
    void leavesADroneToWhoTakesItAndTakesItBackWhenItIsToldTo() {
        start();
        seen(led(new Observation("The pilot flies it.", 0, true, true, false, false, "LOITER", 90, 300.0, null, null)));
        assertThat(state.stage()).isEqualTo(FollowStage.SUSPENDED);
        assertThat(follow.drones(state)).isEmpty();
        silent(
                led(new Observation(
                        "The pilot flies it.", 0, true, true, false, false, "LOITER", 90, 300.0, null, null)),
                5);
        assertThat(given).hasSize(4);
        take(new FollowInput.Resume(at(), "mia"));
        assertThat(follow.drones(state)).containsExactly(state.drone());
        seen(led(new Observation(null, 0, true, true, false, false, "LOITER", 90, 300.0, null, null)));
        succeeds();
        seen(AIR);
        assertThat(given).last().isEqualTo(new Command.SetMode("GUIDED"));
        assertThat(state.stage()).isEqualTo(FollowStage.TRACKING);
    }

    @Test
    void isOverWhenItsDroneIsTakenOnTheGround() {
        seen(led(new Observation(
                "The supervisor has it.", 0, false, false, true, false, "GUIDED", 90, 0.0, null, null)));
        assertThat(state.isOver()).isTrue();
        assertThat(state.end()).contains("The supervisor has it.");
    }

    @Test
    void asksForPositionsAndThenFliesHome() {
        start();
        heard(AIR, 5);
        silent(AIR, 2.8);
        assertThat(state.note()).isNull();
        silent(AIR, 0.5);
        assertThat(state.note()).contains("says nothing any more");
        heard(AIR, 1);
        assertThat(state.note()).isNull();
        silent(AIR, 61);
        assertThat(state.stage()).isEqualTo(FollowStage.RETURNING);
        assertThat(given).last().isEqualTo(new Command.ReturnToLaunch());
    }

    @Test
    void tellsApartWhyPositionsDoNotCome() {
        start();
        heard(AIR, 5);
        reach = ReporterState.SPEAKS;
        silent(AIR, 4);
        assertThat(state.note()).contains("does not know where it is", "flies home 60 s after");
        reach = ReporterState.VAGUE;
        silent(AIR, 1);
        assertThat(state.note()).contains("no better than 50 m", "flies home 60 s after");
        List<String> before =
                state.notices().stream().map(FollowState.Notice::words).toList();
        reach = ReporterState.ASLEEP;
        silent(AIR, 1);
        assertThat(state.note()).contains("stands still: the screen is off");
        reach = ReporterState.CUT;
        silent(AIR, 1);
        assertThat(state.note()).contains("no network");
        reach = ReporterState.GONE;
        silent(AIR, 1);
        assertThat(state.note()).contains("was closed");
        heard(AIR, 1);
        assertThat(state.note()).isNull();
        assertThat(state.notices())
                .hasSize(before.size() + 4)
                .last()
                .extracting(FollowState.Notice::words)
                .isEqualTo("The phone says again where it is.");
    }

    @Test
    void waitsForPositionsAnewAfterARestart() {
        start();
        heard(AIR, 5);
        now += 300;
        sighted = null;
        take(new FollowInput.Restarted(at()));
        silent(AIR, 30);
        assertThat(state.stage()).isEqualTo(FollowStage.TRACKING);
        silent(AIR, 31);
        assertThat(state.stage()).isEqualTo(FollowStage.RETURNING);
    }

    @Test
    void fliesHomeWhileTheBatteryLastsForTheWay() {
        start();
        heard(led(new Observation(null, 0, true, true, true, false, "GUIDED", 26, 300.0, null, null)), 1);
        assertThat(state.stage()).isEqualTo(FollowStage.TRACKING);
        heard(led(new Observation(null, 0, true, true, true, false, "GUIDED", 24, 300.0, null, null)), 1);
        assertThat(state.stage()).isEqualTo(FollowStage.RETURNING);
        assertThat(state.notices().get(state.notices().size() - 1).words()).contains("24 %");
    }

    @Test
    void givesUpAStartThatFailsThreeTimes() {
        take(new FollowInput.Start(at(), "mia"));
        seen(GROUND);
        succeeds();
        for (int time = 0; time < 3; time++) {
            now += 4;
            seen(GROUND);
            ends(new Outcome.Failed("Arm: Compass not calibrated"));
        }
        seen(GROUND);
        assertThat(given).filteredOn(Command.Arm.class::isInstance).hasSize(3);
        assertThat(state.isOver()).isTrue();
        assertThat(state.notices()).extracting(FollowState.Notice::words).anyMatch(words -> words.contains("Compass"));
    }

    @Test
    void triesAgainAndAgainToBringItHome() {
        start();
        take(new FollowInput.Stop(at(), "mia"));
        for (int time = 0; time < 10; time++) {
            now += 4;
            seen(AIR);
            ends(new Outcome.TimedOut("It did not answer."));
        }
        assertThat(state.stage()).isEqualTo(FollowStage.RETURNING);
        assertThat(given).filteredOn(Command.ReturnToLaunch.class::isInstance).hasSize(10);
    }

    @Test
    void commandsNothingWhileTheDroneIsNotHeard() {
        start();
        take(new FollowInput.Stop(at(), "mia"));
        silent(led(new Observation(null, 7, true, true, true, false, "GUIDED", 90, 300.0, null, null)), 30);
        assertThat(given).hasSize(4);
        assertThat(state.note()).contains("no contact");
        seen(AIR);
        assertThat(given).last().isEqualTo(new Command.ReturnToLaunch());
    }

    @Test
    void comesHomeWithADroneThatComesHomeByItself() {
        start();
        seen(HOMING);
        assertThat(state.stage()).isEqualTo(FollowStage.RETURNING);
        silent(HOMING, 5);
        assertThat(given).hasSize(4);
    }

    @Test
    void tellsWhyADroneCannotBeSteered() {
        start();
        sighted = at();
        seen(AIR, "The no-fly zone “Airport” is 12 m away.");
        assertThat(state.note()).contains("Airport");
        FollowState before = state;
        seen(AIR, "The no-fly zone “Airport” is 11 m away.");
        assertThat(state).isEqualTo(before);
        sighted = at();
        seen(AIR);
        assertThat(state.note()).isNull();
    }
}
