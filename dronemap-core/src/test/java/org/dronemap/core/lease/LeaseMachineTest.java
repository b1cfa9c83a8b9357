package org.dronemap.core.lease;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.lease.ControlChange.Kind;
import org.junit.jupiter.api.Test;

class LeaseMachineTest {
    private static final Instant START = Instant.parse("2026-05-01T12:00:00Z");

    private final AtomicLong epochs = new AtomicLong(100);
    private final LeaseMachine machine = new LeaseMachine(LeaseRules.DEFAULT, epochs::incrementAndGet);
    private ControlState control = ControlState.FREE;
    private double seconds;
    private LeaseStep last = new LeaseStep(control, new LeaseAnswer.Granted(), List.of());

    @Test
    void givesAFreeDroneToWhoeverCommandsIt() {
        granted(new LeaseEvent.Command("ann", null));

        assertThat(control.isHeldBy("ann")).isTrue();
        assertThat(control.epoch()).isEqualTo(101);
        assertThat(kinds()).containsExactly(Kind.TAKEN);
    }

    @Test
    void tellsTheOtherWhoHasControlAndSinceWhen() {
        granted(new LeaseEvent.Command("ann", null));

        assertThat(denied(new LeaseEvent.Command("bob", null)))
                .isEqualTo("ann has had control of it since 2026-05-01 12:00:00 UTC; ask for it, or wait until it is"
                        + " given back.");
        assertThat(denied(new LeaseEvent.TakeControl("bob"))).startsWith("ann has had control");
    }

    @Test
    void keepsTheEpochOfOneHolderWhateverTheyCommand() {
        granted(new LeaseEvent.Command("ann", null));
        after(29, new LeaseEvent.Command("ann", null));
        after(29, new LeaseEvent.TimeAdvanced(false, true));

        assertThat(control.isHeldBy("ann")).isTrue();
        assertThat(control.epoch()).isEqualTo(101);
    }

    @Test
    void endsImplicitControlWhenItsHolderIsIdle() {
        granted(new LeaseEvent.Command("ann", null));
        after(30.1, new LeaseEvent.TimeAdvanced(false, true));

        assertThat(control.tenure()).isNull();
        assertThat(control.lapse()).isNotNull();
        assertThat(kinds()).containsExactly(Kind.EXPIRED);
    }

    @Test
    void doesNotCallAHolderIdleWhoseCommandIsUnderWay() {
        granted(new LeaseEvent.Command("ann", null));
        after(60, new LeaseEvent.TimeAdvanced(true, true));
        after(29, new LeaseEvent.TimeAdvanced(false, true));

        assertThat(control.isHeldBy("ann")).isTrue();
    }

    @Test
    void keepsExplicitControlAsLongAsHeartbeatsCome() {
        granted(new LeaseEvent.TakeControl("ann"));
        for (int i = 0; i < 30; i++) {
            after(2, new LeaseEvent.Heartbeat("ann", 101));
            after(0, new LeaseEvent.TimeAdvanced(false, true));
        }

        assertThat(control.isHeldBy("ann")).isTrue();
    }

    @Test
    void losesAnExplicitHolderWhoFallsSilentAndStopsTheirCommands() {
        granted(new LeaseEvent.TakeControl("ann"));
        after(6.1, new LeaseEvent.TimeAdvanced(true, true));

        assertThat(control.tenure()).isNull();
        assertThat(control.epoch()).isEqualTo(102);
        assertThat(kinds()).containsExactly(Kind.LOST);
    }

    @Test
    void callsTheDroneBackOnceWhenNobodyTakesItAfterALoss() {
        granted(new LeaseEvent.TakeControl("ann"));
        after(6.1, new LeaseEvent.TimeAdvanced(false, true));
        after(29, new LeaseEvent.TimeAdvanced(false, true));
        assertThat(kinds()).isEmpty();

        after(1.1, new LeaseEvent.TimeAdvanced(false, true));
        assertThat(kinds()).containsExactly(Kind.RETURN_DUE);

        after(100, new LeaseEvent.TimeAdvanced(false, true));
        assertThat(kinds()).isEmpty();
    }

    @Test
    void waitsWithTheReturnUntilTheDroneIsHeard() {
        granted(new LeaseEvent.TakeControl("ann"));
        after(6.1, new LeaseEvent.TimeAdvanced(false, true));
        after(100, new LeaseEvent.TimeAdvanced(false, false));
        assertThat(kinds()).isEmpty();

        after(1, new LeaseEvent.TimeAdvanced(false, true));
        assertThat(kinds()).containsExactly(Kind.RETURN_DUE);
    }

    @Test
    void callsNothingBackThatSomebodyHasTaken() {
        granted(new LeaseEvent.TakeControl("ann"));
        after(6.1, new LeaseEvent.TimeAdvanced(false, true));
        granted(new LeaseEvent.Command("bob", null));
        after(29.9, new LeaseEvent.Command("bob", null));
        after(20, new LeaseEvent.TimeAdvanced(false, true));

        assertThat(kinds()).isEmpty();
        assertThat(control.lapse()).isNull();
    }

    @Test
    void turnsImplicitControlIntoExplicitWithoutStoppingWhatIsUnderWay() {
        granted(new LeaseEvent.Command("ann", null));
        granted(new LeaseEvent.TakeControl("ann"));

        assertThat(control.epoch()).isEqualTo(101);
        assertThat(control.tenure())
                .satisfies(tenure -> assertThat(tenure.explicit()).isTrue());
    }

    @Test
    void letsOnlyTheNewestWindowOfOneUserKeepControl() {
        granted(new LeaseEvent.TakeControl("ann"));
        granted(new LeaseEvent.TakeControl("ann"));

        assertThat(denied(new LeaseEvent.Heartbeat("ann", 101))).startsWith("Control by epoch 101 has ended.");
        granted(new LeaseEvent.Heartbeat("ann", 102));
        assertThat(denied(new LeaseEvent.Command("ann", 101L))).startsWith("Control by epoch 101 has ended.");
        granted(new LeaseEvent.Command("ann", 102L));
        granted(new LeaseEvent.Command("ann", null));
    }

    @Test
    void asksTheHolderWhoGrants() {
        granted(new LeaseEvent.TakeControl("ann"));
        step(new LeaseEvent.Request("bob", "my turn"));
        assertThat(last.answer()).isEqualTo(new LeaseAnswer.Waiting());
        assertThat(control.requests()).extracting(LeaseRequest::by).containsExactly("bob");

        assertThat(denied(new LeaseEvent.Grant("carl", "bob"))).startsWith("You do not have control. ann");
        granted(new LeaseEvent.Grant("ann", "bob"));

        assertThat(control.isHeldBy("bob")).isTrue();
        assertThat(control.epoch()).isEqualTo(102);
        assertThat(control.requests()).isEmpty();
        assertThat(kinds()).containsExactly(Kind.HANDED_OVER);
    }

    @Test
    void asksTheHolderWhoRefuses() {
        granted(new LeaseEvent.TakeControl("ann"));
        step(new LeaseEvent.Request("bob", null));
        granted(new LeaseEvent.Refuse("ann", "bob", "on final"));

        assertThat(control.isHeldBy("ann")).isTrue();
        assertThat(control.requests()).isEmpty();
        assertThat(last.changes())
                .containsExactly(new ControlChange(
                        Kind.REFUSED, new LeaseHolder.Person("ann"), new LeaseHolder.Person("bob"), "on final"));
    }

    @Test
    void forgetsARequestThatIsAMinuteOld() {
        granted(new LeaseEvent.Command("ann", null));
        step(new LeaseEvent.Request("bob", null));
        after(25, new LeaseEvent.Command("ann", null));
        after(25, new LeaseEvent.Command("ann", null));
        after(10.1, new LeaseEvent.TimeAdvanced(false, true));

        assertThat(control.requests()).isEmpty();
        assertThat(denied(new LeaseEvent.Grant("ann", "bob"))).startsWith("bob does not ask");
    }

    @Test
    void grantsAtOnceWhatIsFree() {
        granted(new LeaseEvent.Request("bob", "for the survey"));

        assertThat(control.isHeldBy("bob")).isTrue();
    }

    @Test
    void waitsForWhoWasHandedControlWithoutLookingAndThenCallsTheDroneBack() {
        granted(new LeaseEvent.TakeControl("ann"));
        granted(new LeaseEvent.HandOver("ann", "bob"));
        after(30.1, new LeaseEvent.TimeAdvanced(false, true));

        assertThat(kinds()).containsExactly(Kind.EXPIRED);
        after(30.1, new LeaseEvent.TimeAdvanced(false, true));
        assertThat(kinds()).containsExactly(Kind.RETURN_DUE);
    }

    @Test
    void takesOverWithAReason() {
        granted(new LeaseEvent.TakeControl("ann"));
        granted(new LeaseEvent.TakeOver("sue", "smoke"));

        assertThat(control.isHeldBy("sue")).isTrue();
        assertThat(last.changes())
                .containsExactly(new ControlChange(
                        Kind.TAKEN_OVER, new LeaseHolder.Person("sue"), new LeaseHolder.Person("ann"), "smoke"));
        assertThat(denied(new LeaseEvent.Heartbeat("ann", 101))).contains("sue has had control");
    }

    @Test
    void givesWayToThePilotAtTheVehicleUntilSomebodyTakesControl() {
        granted(new LeaseEvent.TakeControl("ann"));
        granted(new LeaseEvent.PilotActed("LOITER"));

        assertThat(denied(new LeaseEvent.Command("ann", null)))
                .isEqualTo(
                        "A pilot at the vehicle or another ground station has had control of it since 2026-05-01 12:00:00 UTC; take control"
                                + " to command it again.");
        after(100, new LeaseEvent.TimeAdvanced(false, true));
        assertThat(control.tenure()).isNotNull();

        granted(new LeaseEvent.TakeControl("ann"));
        granted(new LeaseEvent.Command("ann", null));
        assertThat(control.epoch()).isEqualTo(103);
    }

    @Test
    void isFreeAgainWhenThePilotHasLanded() {
        granted(new LeaseEvent.TakeControl("ann"));
        granted(new LeaseEvent.PilotActed("LOITER"));
        granted(new LeaseEvent.PilotLeft());

        assertThat(control.tenure()).isNull();
        granted(new LeaseEvent.Command("bob", null));
    }

    @Test
    void takesControlFromWhoMayCommandNoMore() {
        granted(new LeaseEvent.TakeControl("ann"));
        step(new LeaseEvent.Request("bob", null));
        granted(new LeaseEvent.Expel("bob"));
        assertThat(control.requests()).isEmpty();

        granted(new LeaseEvent.Expel("ann"));
        assertThat(control.tenure()).isNull();
        assertThat(control.epoch()).isEqualTo(102);
        assertThat(control.lapse()).isNotNull();
    }

    @Test
    void givesBackOnlyWhatOneHas() {
        assertThat(denied(new LeaseEvent.Release("ann")))
                .isEqualTo("You do not have control. Nobody has control; take" + " it.");
        granted(new LeaseEvent.TakeControl("ann"));
        granted(new LeaseEvent.Release("ann"));

        assertThat(control.tenure()).isNull();
    }

    @Test
    void givesAHolderTimeToComeBackAfterARestart() {
        control = machine.restored(
                new SavedLease(new DroneId("d1"), "ann", START.minusSeconds(60), 77, false),
                new ClockReading(START, 0));

        after(15, new LeaseEvent.TimeAdvanced(false, true));
        assertThat(control.isHeldBy("ann")).isTrue();
        assertThat(control.epoch()).isEqualTo(101);
        after(6.1, new LeaseEvent.TimeAdvanced(false, true));
        assertThat(kinds()).containsExactly(Kind.LOST);
    }

    @Test
    void stillOwesTheReturnAfterARestart() {
        control = machine.restored(
                new SavedLease(new DroneId("d1"), "ann", START.minusSeconds(60), 77, true), new ClockReading(START, 0));
        assertThat(control.tenure()).isNull();
        assertThat(control.epoch()).isEqualTo(101);

        after(29, new LeaseEvent.TimeAdvanced(false, true));
        assertThat(kinds()).isEmpty();
        after(1.1, new LeaseEvent.TimeAdvanced(false, true));
        assertThat(kinds()).containsExactly(Kind.RETURN_DUE);
    }

    @Test
    void knowsAHolderByTheEpochFromBeforeARestart() {
        control = machine.restored(
                new SavedLease(new DroneId("d1"), "ann", START, 77, false), new ClockReading(START, 0));

        granted(new LeaseEvent.Heartbeat("ann", 77));
        granted(new LeaseEvent.Command("ann", 77L));
        assertThat(denied(new LeaseEvent.Heartbeat("ann", 76))).startsWith("Control by epoch 76 has ended.");
        granted(new LeaseEvent.TakeControl("ann"));
        assertThat(denied(new LeaseEvent.Heartbeat("ann", 77))).startsWith("Control by epoch 77 has ended.");
    }

    private void after(double more, LeaseEvent event) {
        seconds += more;
        step(event);
    }

    private void granted(LeaseEvent event) {
        step(event);
        assertThat(last.answer()).isEqualTo(new LeaseAnswer.Granted());
    }

    private String denied(LeaseEvent event) {
        ControlState before = control;
        step(event);
        assertThat(control).isEqualTo(before);
        assertThat(last.answer()).isInstanceOf(LeaseAnswer.Denied.class);
        return ((LeaseAnswer.Denied) last.answer()).why();
    }

    private void step(LeaseEvent event) {
        long nanos = Math.round(seconds * 1e9);
        last = machine.apply(control, event, new ClockReading(START.plus(Duration.ofNanos(nanos)), nanos));
        control = last.control();
    }

    private List<Kind> kinds() {
        return last.changes().stream().map(ControlChange::kind).toList();
    }
}
