package org.dronemap.cognitive.operation.follow;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronemap.cognitive.operation.follow.FollowInput.Observation;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.SetReturnOnCloudLoss;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.operation.ChosenDrone;
import org.dronemap.core.operation.OperationAction;
import org.dronemap.core.operation.OperationDecision;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** One drone takes over from another that runs low. */
class ReliefHandoverTest extends FollowTestBase {
    private static final DroneId FALCON = new DroneId("d1");
    private static final DroneId KESTREL = new DroneId("d2");
    private static final DroneId OSPREY = new DroneId("d3");
    private static final Observation LOW =
            led(new Observation(null, 0, true, true, true, false, "GUIDED", 24, 300.0, null, null));
    private static final Observation TAKEN =
            led(new Observation("sue has it.", 0, true, true, true, false, "GUIDED", 90, 300.0, null, null));

    private final Map<DroneId, Observation> looks = new HashMap<>();
    private final Map<DroneId, Double> apart = new HashMap<>();
    private final Map<DroneId, List<Command>> told = new HashMap<>();

    private final Set<CommandId> ids = new HashSet<>();

    private static ChosenDrone chosen(DroneId drone, String name) {
        return new ChosenDrone(drone, name, HOME, 488, name + " was chosen.");
    }

    private void relieve(DroneId drone, String name) {
        decide(new FollowInput.SendRelief(at(), chosen(drone, name)));
        looks.put(drone, GROUND);
    }

    private void decide(FollowInput input) {
        OperationDecision<FollowState, FollowInput> decision = follow.decide(state, input);
        state = decision.next();
        for (OperationAction<FollowInput> action : decision.actions()) {
            OperationAction.SendCommand<FollowInput> give = (OperationAction.SendCommand<FollowInput>) action;
            assertThat(ids.add(give.id())).as("the same id twice acts once").isTrue();
            told.computeIfAbsent(give.drone(), drone -> new ArrayList<>()).add(give.command());
            obey(give.drone(), give.command());
            now += 0.1;
            decide(new FollowInput.CommandEnded(at(), give.drone(), give.id(), new Outcome.Succeeded()));
        }
    }

    private void obey(DroneId drone, Command command) {
        if (command instanceof Command.Arm) {
            looks.put(drone, ARMED);
        } else if (command instanceof Command.TakeOff) {
            looks.put(drone, AIR);
        } else if (command instanceof Command.ReturnToLaunch) {
            looks.put(drone, HOMING);
        }
    }

    private void pass(double seconds) {
        for (double passed = 0; passed < seconds; passed += 0.1) {
            now += 0.1;
            sighted = at();
            List<FollowInput.OtherDrone> others = state.reliefOrNone().others().stream()
                    .map(FollowState::drone)
                    .map(drone -> new FollowInput.OtherDrone(drone, looks.get(drone), apart.get(drone)))
                    .toList();
            decide(new FollowInput.Observed(at(), looks.get(state.drone()), sighted, null, null, others));
        }
    }

    private void follows() {
        start();
        looks.put(FALCON, AIR);
        pass(1);
    }

    private List<String> words() {
        return state.notices().stream().map(FollowState.Notice::words).toList();
    }

    private @Nullable FollowStage stageOf(DroneId drone) {
        return state.reliefOrNone().others().stream()
                .filter(other -> other.drone().equals(drone))
                .map(FollowState::stage)
                .findFirst()
                .orElse(null);
    }

    @Test
    void sendsTheOldOneHomeOnlyWhenTheNewOneIsThere() {
        follows();
        relieve(KESTREL, "Kestrel");
        assertThat(words()).last().isEqualTo("Falcon runs low; Kestrel comes to replace it. Kestrel was chosen.");
        assertThat(follow.drones(state)).containsExactlyInAnyOrder(FALCON, KESTREL);
        apart.put(KESTREL, 300.0);
        pass(20);
        assertThat(told.get(KESTREL))
                .containsExactly(new SetReturnOnCloudLoss(), new Command.Arm(), new Command.TakeOff(15));
        assertThat(state.drone()).isEqualTo(FALCON);
        assertThat(state.stage()).isEqualTo(FollowStage.TRACKING);
        assertThat(stageOf(KESTREL)).isEqualTo(FollowStage.TRACKING);
        assertThat(words()).last().isEqualTo("Kestrel is in the air and comes.");
        apart.put(KESTREL, 25.0);
        pass(0.1);
        assertThat(state.drone()).isEqualTo(KESTREL);
        assertThat(state.stage()).isEqualTo(FollowStage.TRACKING);
        assertThat(stageOf(FALCON)).isEqualTo(FollowStage.RETURNING);
        assertThat(words()).last().isEqualTo("Kestrel has taken over; Falcon flies home.");
        pass(5);
        assertThat(told.get(FALCON)).as("it is led home").isNull();
        looks.put(FALCON, led(new Observation(null, 0, true, true, true, false, "GUIDED", 24, 14.0, null, null)));
        pass(0.1);
        assertThat(told.get(FALCON)).containsExactly(new Command.ReturnToLaunch());
        looks.put(FALCON, GROUND);
        pass(1);
        assertThat(words()).last().isEqualTo("Falcon is down.");
        assertThat(follow.drones(state)).containsExactly(KESTREL);
        assertThat(state.reliefOrNone().failed()).isEmpty();
    }

    @Test
    void leavesTheOldOneToItselfWhenItHasLittleLeftOrWasLedForLong() {
        follows();
        relieve(KESTREL, "Kestrel");
        apart.put(KESTREL, 20.0);
        pass(10);
        assertThat(stageOf(FALCON)).isEqualTo(FollowStage.RETURNING);
        pass(50 - 10);
        assertThat(told.get(FALCON)).isNull();
        pass(25);
        assertThat(told.get(FALCON)).containsExactly(new Command.ReturnToLaunch());
        looks.put(FALCON, HOMING);
        relieve(OSPREY, "Osprey");
        apart.put(OSPREY, 20.0);
        pass(2);
        looks.put(KESTREL, LOW);
        pass(10);
        assertThat(state.drone()).isEqualTo(OSPREY);
        assertThat(told.get(KESTREL)).last().isEqualTo(new Command.ReturnToLaunch());
    }

    @Test
    void isRelievedAgainAndAgain() {
        follows();
        relieve(KESTREL, "Kestrel");
        apart.put(KESTREL, 20.0);
        pass(10);
        relieve(OSPREY, "Osprey");
        apart.put(OSPREY, 20.0);
        pass(10);
        assertThat(state.drone()).isEqualTo(OSPREY);
        looks.put(FALCON, GROUND);
        looks.put(KESTREL, GROUND);
        pass(1);
        relieve(FALCON, "Falcon");
        apart.put(FALCON, 20.0);
        pass(10);
        assertThat(state.drone()).isEqualTo(FALCON);
        assertThat(told.get(FALCON)).contains(new SetReturnOnCloudLoss(), new Command.TakeOff(15));
        assertThat(state.reliefOrNone().sent()).isEqualTo(3);
    }

    @Test
    void takesOverOnTheWayWhenTheOldOneHasToLeave() {
        follows();
        relieve(KESTREL, "Kestrel");
        apart.put(KESTREL, 400.0);
        looks.put(FALCON, LOW);
        pass(0.2);
        assertThat(state.stage()).isEqualTo(FollowStage.RETURNING);
        assertThat(state.drone()).isEqualTo(FALCON);
        pass(10);
        assertThat(state.drone()).isEqualTo(KESTREL);
        assertThat(state.stage()).isEqualTo(FollowStage.TRACKING);
        assertThat(words()).last().isEqualTo("Kestrel has taken over; Falcon goes on home.");
    }

    @Test
    void mayStillBeReplacedOnItsWayHome() {
        follows();
        looks.put(FALCON, LOW);
        pass(1);
        assertThat(state.stage()).isEqualTo(FollowStage.RETURNING);
        decide(new FollowInput.NoReliefAvailable(at(), "Kestrel: It is armed or in the air."));
        decide(new FollowInput.NoReliefAvailable(at(), "Kestrel: Its battery has 30 %."));
        assertThat(words())
                .filteredOn(one -> one.contains("No other drone can replace"))
                .hasSize(1);
        relieve(KESTREL, "Kestrel");
        pass(10);
        assertThat(state.drone()).isEqualTo(KESTREL);
    }

    @Test
    void goesOnWithTheOtherWhenTheOldOneIsDownBeforeItIsUp() {
        follows();
        looks.put(FALCON, LOW);
        pass(1);
        relieve(KESTREL, "Kestrel");
        looks.put(FALCON, GROUND);
        pass(0.1);
        assertThat(state.drone()).isEqualTo(KESTREL);
        assertThat(state.stage()).isEqualTo(FollowStage.STARTING);
        assertThat(state.end()).isNull();
        pass(10);
        assertThat(state.stage()).isEqualTo(FollowStage.TRACKING);
    }

    @Test
    void takesOverFromOneThatWasLost() {
        follows();
        relieve(KESTREL, "Kestrel");
        apart.put(KESTREL, 400.0);
        pass(10);
        looks.remove(FALCON);
        pass(0.1);
        assertThat(state.drone()).isEqualTo(KESTREL);
        assertThat(state.stage()).isEqualTo(FollowStage.TRACKING);
        assertThat(words()).contains("Falcon was removed.").last().isEqualTo("Kestrel has taken over.");
    }

    @Test
    void asksForAnotherWhenOneFailsOnItsWay() {
        follows();
        relieve(KESTREL, "Kestrel");
        looks.put(
                KESTREL,
                led(new Observation("sue has it.", 0, false, false, true, false, "GUIDED", 90, 0.0, null, null)));
        pass(0.5);
        assertThat(state.stage()).isEqualTo(FollowStage.TRACKING);
        assertThat(state.isRelievable()).isTrue();
        assertThat(state.reliefOrNone().failed()).containsExactly(KESTREL);
        assertThat(state.reliefOrNone().others()).isEmpty();
        relieve(OSPREY, "Osprey");
        apart.put(OSPREY, 20.0);
        pass(10);
        assertThat(state.drone()).isEqualTo(OSPREY);
    }

    @Test
    void leavesOneThatIsTakenOnItsWayToWhoTookIt() {
        follows();
        relieve(KESTREL, "Kestrel");
        apart.put(KESTREL, 300.0);
        pass(10);
        looks.put(KESTREL, TAKEN);
        pass(1);
        assertThat(stageOf(KESTREL)).isEqualTo(FollowStage.SUSPENDED);
        assertThat(follow.drones(state)).containsExactly(FALCON);
        assertThat(state.isRelievable()).isTrue();
        looks.put(KESTREL, HOMING);
        looks.put(FALCON, LOW);
        pass(1);
        assertThat(state.drone()).as("who has it keeps it").isEqualTo(FALCON);
    }

    @Test
    void stopsWithBoth() {
        follows();
        relieve(KESTREL, "Kestrel");
        apart.put(KESTREL, 300.0);
        pass(10);
        decide(new FollowInput.Stop(at(), "mia"));
        pass(1);
        assertThat(state.stage()).isEqualTo(FollowStage.RETURNING);
        assertThat(stageOf(KESTREL)).isEqualTo(FollowStage.RETURNING);
        assertThat(told.get(KESTREL)).last().isEqualTo(new Command.ReturnToLaunch());
        looks.put(FALCON, GROUND);
        pass(0.2);
        assertThat(state.isOver()).as("the other one flies still").isFalse();
        assertThat(state.drone()).isEqualTo(KESTREL);
        looks.put(KESTREL, GROUND);
        pass(0.2);
        assertThat(state.isOver()).isTrue();
        assertThat(follow.drones(state)).isEmpty();
    }

    @Test
    void canBeStoppedWhileAnotherOneComesForOneThatFliesHome() {
        follows();
        looks.put(FALCON, LOW);
        pass(1);
        relieve(KESTREL, "Kestrel");
        FollowInput stop = new FollowInput.Stop(at(), "mia");
        assertThat(follow.refusal(state, stop)).isEmpty();
        decide(stop);
        pass(1);
        assertThat(stageOf(KESTREL)).isIn(null, FollowStage.RETURNING);
        assertThat(state.isRelievable()).isFalse();
        assertThat(follow.refusal(state, stop)).isPresent();
    }

    @Test
    void callsTheOtherHomeWhenNobodyIsFollowedAnyMore() {
        follows();
        relieve(KESTREL, "Kestrel");
        apart.put(KESTREL, 300.0);
        pass(10);
        looks.put(FALCON, TAKEN);
        pass(0.1);
        assertThat(state.stage()).isEqualTo(FollowStage.SUSPENDED);
        assertThat(stageOf(KESTREL)).isEqualTo(FollowStage.RETURNING);
    }

    @Test
    void isReplacedNeitherInAPauseNorWhileThePhoneIsSilent() {
        follows();
        decide(new FollowInput.Pause(at(), "mia"));
        assertThat(follow.refusal(state, new FollowInput.SendRelief(at(), chosen(KESTREL, "Kestrel"))))
                .isPresent();
        decide(new FollowInput.Resume(at(), "mia"));
        pass(1);
        assertThat(state.isRelievable()).isTrue();
        silent(AIR, 4);
        assertThat(state.isRelievable()).isFalse();
    }

    @Test
    void goesOnWithBothAfterARestart() {
        follows();
        relieve(KESTREL, "Kestrel");
        apart.put(KESTREL, 300.0);
        pass(10);
        now += 20;
        decide(new FollowInput.Restarted(at()));
        looks.put(FALCON, HOMING);
        looks.put(KESTREL, HOMING);
        pass(10);
        assertThat(told.get(KESTREL)).last().isEqualTo(new Command.SetMode("GUIDED"));
        assertThat(stageOf(KESTREL)).isEqualTo(FollowStage.STARTING);
    }
}
