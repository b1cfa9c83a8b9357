package org.dronemap.cognitive.operation.follow;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronemap.cognitive.follow.Side;
import org.dronemap.cognitive.operation.follow.FollowInput.Look;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.operation.Action;
import org.dronemap.core.operation.Decision;
import org.dronemap.core.operation.OperationId;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** From asking to be followed to the drone's being down again. */
class FollowTest {
    private static final Instant ZERO = Instant.parse("2026-05-01T12:00:00Z");
    private static final Geodetic HOME = new Geodetic(47.3977, 8.5456);
    private static final FollowOrder.Place BEHIND = new FollowOrder.Place(new Side.Behind(), 8, 15);
    private static final Look GROUND = new Look(null, 0, false, false, true, false, "GUIDED", 90, 0.0);
    private static final Look ARMED = new Look(null, 0, true, false, true, false, "GUIDED", 90, 0.0);
    private static final Look AIR = new Look(null, 0, true, true, true, false, "GUIDED", 90, 300.0);
    private static final Look HOMING = new Look(null, 0, true, true, false, true, "RTL", 90, 300.0);

    private final Follow follow = new Follow();
    private final List<Command> given = new ArrayList<>();
    private FollowState state = FollowState.begin(
            new OperationId("follow-1"),
            new FollowOrder(
                    new FollowOrder.Chosen(new DroneId("d1"), "Falcon", HOME, 488, "Falcon was chosen."),
                    HOME,
                    BEHIND,
                    12,
                    new FollowOrder.Fences(List.of(), List.of()),
                    60),
            ZERO);
    private double now;
    private @Nullable Instant sighted;

    private Instant at() {
        return ZERO.plusMillis(Math.round(now * 1_000));
    }

    private void take(FollowInput input) {
        Decision<FollowState, FollowInput> decision = follow.decide(state, input);
        state = decision.next();
        for (Action<FollowInput> action : decision.actions()) {
            given.add(((Action.Give<FollowInput>) action).command());
        }
    }

    private void seen(Look look) {
        seen(look, null);
    }

    private void seen(Look look, @Nullable String unsteered) {
        now += 0.1;
        take(new FollowInput.Looked(at(), look, sighted, unsteered));
    }

    /** For so long, with a position each time. */
    private void heard(Look look, double seconds) {
        for (double passed = 0; passed < seconds; passed += 0.1) {
            sighted = at();
            seen(look);
        }
    }

    private void silent(Look look, double seconds) {
        for (double passed = 0; passed < seconds; passed += 0.1) {
            seen(look);
        }
    }

    private void ends(Outcome outcome) {
        FollowState.Errand errand = state.errand();
        assertThat(errand).isNotNull();
        take(new FollowInput.CommandEnded(at(), state.drone(), errand.command(), outcome));
        now += 1;
    }

    private void succeeds() {
        ends(new Outcome.Succeeded());
    }

    private void start() {
        take(new FollowInput.Start(at(), "mia"));
        seen(new Look(null, 0, false, false, false, false, "LOITER", 90, 0.0));
        succeeds();
        seen(GROUND);
        succeeds();
        seen(ARMED);
        succeeds();
        seen(AIR);
    }

    @Test
    void takesOffFollowsComesHomeAndIsOver() {
        start();
        assertThat(given).containsExactly(new Command.SetMode("GUIDED"), new Command.Arm(), new Command.TakeOff(15));
        assertThat(state.stage()).isEqualTo(Stage.TRACKING);
        heard(AIR, 100);
        assertThat(state.stage()).isEqualTo(Stage.TRACKING);
        take(new FollowInput.Stop(at(), "mia"));
        seen(AIR);
        succeeds();
        silent(HOMING, 20);
        assertThat(given).hasSize(4).last().isEqualTo(new Command.ReturnToLaunch());
        assertThat(state.isOver()).isFalse();
        seen(GROUND);
        assertThat(state.isOver()).isTrue();
        assertThat(follow.drones(state)).isEmpty();
    }

    /** Each wish at each stage: what comes of it, or why it is not taken. */
    @Test
    void answersEachWishAtEachStageAsTheTableSays() {
        Map<Stage, FollowState> stages = new EnumMap<>(Stage.class);
        stages.put(Stage.ALLOCATED, state);
        for (Stage stage : List.of(Stage.STARTING, Stage.TRACKING, Stage.PAUSED, Stage.SUSPENDED, Stage.RETURNING)) {
            stages.put(stage, state.to(stage, ZERO, "so it was"));
        }
        Map<String, FollowInput.Wish> wishes = new LinkedHashMap<>();
        wishes.put("start", new FollowInput.Start(ZERO, "mia"));
        wishes.put("cancel", new FollowInput.Cancel(ZERO, "mia"));
        wishes.put("pause", new FollowInput.Pause(ZERO, "mia"));
        wishes.put("continue", new FollowInput.GoOn(ZERO, "mia"));
        wishes.put("stop", new FollowInput.Stop(ZERO, "mia"));
        wishes.put("change", new FollowInput.Change(ZERO, "mia", BEHIND));
        List<String> table = new ArrayList<>();
        stages.forEach((stage, before) -> {
            StringBuilder line = new StringBuilder(stage.toString());
            wishes.forEach((name, wish) -> {
                boolean refused = follow.refusal(before, wish).isPresent();
                Stage next = follow.decide(before, wish).next().stage();
                line.append(' ').append(name).append('=').append(refused ? "no" : next);
                assertThat(refused && next != stage).as(stage + " " + name).isFalse();
            });
            table.add(line.toString());
        });
        assertThat(table)
                .containsExactly(
                        "ALLOCATED start=STARTING cancel=OVER pause=no continue=no stop=no change=ALLOCATED",
                        "STARTING start=no cancel=RETURNING pause=no continue=no stop=RETURNING change=STARTING",
                        "TRACKING start=no cancel=no pause=PAUSED continue=no stop=RETURNING change=TRACKING",
                        "PAUSED start=no cancel=no pause=no continue=STARTING stop=RETURNING change=PAUSED",
                        "SUSPENDED start=no cancel=no pause=no continue=STARTING stop=OVER change=SUSPENDED",
                        "RETURNING start=no cancel=no pause=no continue=no stop=no change=no");
    }

    @Test
    void leavesADroneToWhoTakesItAndTakesItBackWhenItIsToldTo() {
        start();
        seen(new Look("The pilot flies it.", 0, true, true, false, false, "LOITER", 90, 300.0));
        assertThat(state.stage()).isEqualTo(Stage.SUSPENDED);
        assertThat(follow.drones(state)).isEmpty();
        silent(new Look("The pilot flies it.", 0, true, true, false, false, "LOITER", 90, 300.0), 5);
        assertThat(given).hasSize(3);
        take(new FollowInput.GoOn(at(), "mia"));
        assertThat(follow.drones(state)).containsExactly(state.drone());
        seen(new Look(null, 0, true, true, false, false, "LOITER", 90, 300.0));
        succeeds();
        seen(AIR);
        assertThat(given).last().isEqualTo(new Command.SetMode("GUIDED"));
        assertThat(state.stage()).isEqualTo(Stage.TRACKING);
    }

    @Test
    void isOverWhenItsDroneIsTakenOnTheGround() {
        seen(new Look("The supervisor has it.", 0, false, false, true, false, "GUIDED", 90, 0.0));
        assertThat(state.isOver()).isTrue();
        assertThat(state.end()).contains("The supervisor has it.");
    }

    @Test
    void asksForPositionsAndThenFliesHome() {
        start();
        heard(AIR, 5);
        silent(AIR, 9);
        assertThat(state.note()).isNull();
        silent(AIR, 2);
        assertThat(state.note()).contains("says nothing any more");
        heard(AIR, 1);
        assertThat(state.note()).isNull();
        silent(AIR, 61);
        assertThat(state.stage()).isEqualTo(Stage.RETURNING);
        assertThat(given).last().isEqualTo(new Command.ReturnToLaunch());
    }

    @Test
    void waitsForPositionsAnewAfterARestart() {
        start();
        heard(AIR, 5);
        now += 300;
        sighted = null;
        take(new FollowInput.Resumed(at()));
        silent(AIR, 30);
        assertThat(state.stage()).isEqualTo(Stage.TRACKING);
        silent(AIR, 31);
        assertThat(state.stage()).isEqualTo(Stage.RETURNING);
    }

    @Test
    void fliesHomeWhileTheBatteryLastsForTheWay() {
        start();
        heard(new Look(null, 0, true, true, true, false, "GUIDED", 26, 300.0), 1);
        assertThat(state.stage()).isEqualTo(Stage.TRACKING);
        heard(new Look(null, 0, true, true, true, false, "GUIDED", 24, 300.0), 1);
        assertThat(state.stage()).isEqualTo(Stage.RETURNING);
        assertThat(state.told().get(state.told().size() - 1).words()).contains("24 %");
    }

    @Test
    void givesUpAStartThatFailsThreeTimes() {
        take(new FollowInput.Start(at(), "mia"));
        for (int time = 0; time < 3; time++) {
            now += 4;
            seen(GROUND);
            ends(new Outcome.Failed("Arm: Compass not calibrated"));
        }
        seen(GROUND);
        assertThat(given).hasSize(3).allMatch(Command.Arm.class::isInstance);
        assertThat(state.isOver()).isTrue();
        assertThat(state.told()).extracting(FollowState.Told::words).anyMatch(words -> words.contains("Compass"));
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
        assertThat(state.stage()).isEqualTo(Stage.RETURNING);
        assertThat(given).filteredOn(Command.ReturnToLaunch.class::isInstance).hasSize(10);
    }

    @Test
    void commandsNothingWhileTheDroneIsNotHeard() {
        start();
        take(new FollowInput.Stop(at(), "mia"));
        silent(new Look(null, 7, true, true, true, false, "GUIDED", 90, 300.0), 30);
        assertThat(given).hasSize(3);
        assertThat(state.note()).contains("no contact");
        seen(AIR);
        assertThat(given).last().isEqualTo(new Command.ReturnToLaunch());
    }

    @Test
    void comesHomeWithADroneThatComesHomeByItself() {
        start();
        seen(HOMING);
        assertThat(state.stage()).isEqualTo(Stage.RETURNING);
        silent(HOMING, 5);
        assertThat(given).hasSize(3);
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
