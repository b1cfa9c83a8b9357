package org.dronemap.core.cloud;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OwnersKeeper;
import org.dronemap.core.command.PutBack;
import org.dronemap.core.command.SetCloudLoss;
import org.dronemap.core.command.SetReturnHeight;
import org.dronemap.core.drone.CloudLossState;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.LossAction;
import org.dronemap.core.drone.OwnersValues;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.parameter.OwnersValue;
import org.dronemap.core.parameter.ParameterValue;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What a drone does without the cloud: set before it is armed from here, and put back once its use is over. */
class LossPreparationTest extends GuidedFlight {
    private static final OwnersValue VALUE = new OwnersValue("FS_GCS_ENABLE", 0, 1);
    private static final LossAction GOES_ON = new LossAction("it goes on", null, "");
    private static final LossAction COMES_HOME = new LossAction("it returns home", 20.0, "");

    @BeforeEach
    void stand() {
        vehicle.settlesAtOnce = false;
        landed();
        // It says something all the time.
        link.lane().execute(() -> link.lane().addTicker(() -> link.heard()));
    }

    private void landed() {
        hear(new DroneEvent.ModeHeard("GUIDED", false));
        hear(new DroneEvent.PhaseHeard(FlightPhase.ON_GROUND));
    }

    private CommandRecord arms(String id) {
        return gate.submit(ANN, link.id(), id(id), new Command.Arm());
    }

    /** The command of the rule that the vehicle was given last. */
    private <C extends Command> C rule(Class<C> kind) {
        until(() -> vehicle.performed.stream().anyMatch(kind::isInstance));
        return vehicle.performed.stream()
                .filter(kind::isInstance)
                .map(kind::cast)
                .reduce((first, second) -> second)
                .orElseThrow();
    }

    private VehicleChannel.Report ruleReport(Class<? extends Command> kind) {
        until(() -> vehicle.performed.stream().anyMatch(kind::isInstance));
        return commands.records.values().stream()
                .filter(record ->
                        record.by().equals("dronemap") && record.type().equals(kind.getSimpleName()))
                .filter(record -> record.outcome() == null)
                .map(this::report)
                .findFirst()
                .orElseThrow();
    }

    private CompletableFuture<Void> keeps(SetCloudLoss command, OwnersValue... values) {
        CompletableFuture<Void> kept = command.keeper()
                .keep(new OwnersKeeper.Plan(
                        GOES_ON, COMES_HOME, List.of(values), command.keeper().returnMeters(15)));
        time.settle();
        return kept;
    }

    private void isSet() {
        SetCloudLoss command = rule(SetCloudLoss.class);
        assertThat(keeps(command, VALUE)).isCompleted();
        ruleReport(SetCloudLoss.class).ended(new Outcome.Succeeded());
        time.settle();
    }

    /** It was armed once from here, and stands again while nobody has control. */
    private void wasUsed() {
        CommandRecord arm = arms("arm-used1");
        isSet();
        report(arm).ended(new Outcome.Succeeded());
        vehicle.performed.clear();
    }

    private CloudLossState shown() {
        return cloud.cloudLoss(link.id());
    }

    private List<String> told() {
        DroneState now = cloud.drone(link.id()).orElseThrow();
        return now.messages().stream().map(message -> message.text()).toList();
    }

    @Test
    void setsItBeforeItIsArmedAndKeepsWhatItsOwnerHadFirst() {
        CommandRecord arm = arms("arm-00001");
        SetCloudLoss command = rule(SetCloudLoss.class);
        assertThat(vehicle.performed).containsExactly(command);
        assertThat(command.afterSeconds()).isEqualTo(20);

        assertThat(keeps(command, VALUE)).isCompleted();
        assertThat(owners.kept.get(link.id()).values()).containsExactly(VALUE);
        assertThat(owners.kept.get(link.id()).written()).isFalse();
        assertThat(vehicle.performed).hasSize(1);
        ruleReport(SetCloudLoss.class).ended(new Outcome.Succeeded());
        time.settle();

        report(arm);
        assertThat(vehicle.performed).containsExactly(command, new Command.Arm());
        assertThat(owners.kept.get(link.id()).written()).isTrue();
        assertThat(shown().state()).isEqualTo(CloudLossState.State.SET);
        assertThat(shown().sentence())
                .isEqualTo("When it does not hear the cloud any more, it returns home after 20 s.");
        assertThat(shown().outstanding()).containsExactly(VALUE);
        assertThat(commands.records.values())
                .filteredOn(record -> record.by().equals("dronemap"))
                .singleElement()
                .satisfies(record -> {
                    assertThat(record.face()).isEqualTo("rule");
                    assertThat(record.summary()).isEqualTo("set what it does without the cloud");
                    assertThat(record.outcome()).isEqualTo(new Outcome.Succeeded());
                });
    }

    @Test
    void setsItOnceForAUse() {
        wasUsed();

        report(arms("arm-00002"));

        assertThat(vehicle.performed).containsExactly(new Command.Arm());
    }

    @Test
    void setsItBeforeARunReadsHowHighItFliesHome() {
        gate.submit(ANN, link.id(), id("height-01"), new SetReturnHeight(40, true));
        isSet();

        until(() -> vehicle.performed.size() == 2);
        assertThat(vehicle.performed.get(1)).isEqualTo(new SetReturnHeight(40, true));
    }

    @Test
    void armsAllTheSameWhenItCannotBeSetAndSaysWhatItDoesThen() {
        CommandRecord arm = arms("arm-00001");
        keeps(rule(SetCloudLoss.class), VALUE);
        ruleReport(SetCloudLoss.class).ended(new Outcome.Failed("The vehicle did not take it."));

        report(arm);
        assertThat(shown().state()).isEqualTo(CloudLossState.State.NOT_SET);
        assertThat(told())
                .contains(
                        "What it does without the cloud could not be set (The vehicle did not take it). As its owner had"
                                + " set it: When it does not hear the cloud any more, it goes on.");
    }

    @Test
    void armsAllTheSameWhenTheVehicleDoesNotAnswer() {
        long began = time.nanos();
        CommandRecord arm = arms("arm-00001");

        report(arm);

        assertThat(Duration.ofNanos(time.nanos() - began)).isLessThan(Duration.ofSeconds(8));
        assertThat(told()).anyMatch(text -> text.contains("It was not done within 7 s"));
        assertThat(vehicle.cancelled).hasSize(1);
    }

    @Test
    void isNotKeptWhileTheDatabaseIsAway() {
        owners.broken = true;
        arms("arm-00001");

        assertThat(keeps(rule(SetCloudLoss.class), VALUE)).isCompletedExceptionally();
        assertThat(owners.kept).isEmpty();
        assertThat(shown().outstanding()).isEmpty();
    }

    @Test
    void writesNothingToWhatIsInTheAir() {
        hoverInGuided();

        report(gate.submit(ANN, link.id(), id("height-01"), new SetReturnHeight(40, true)));

        assertThat(vehicle.performed).containsExactly(new SetReturnHeight(40, true));
    }

    @Test
    void stopsWhenSomebodyElseArmsItMeanwhile() {
        CommandRecord arm = arms("arm-00001");
        rule(SetCloudLoss.class);

        hear(new DroneEvent.ModeHeard("LOITER", true));
        until(() -> commands.records.get(arm.id()).outcome() != null);

        assertThat(vehicle.cancelled).hasSize(1);
        assertThat(commands.records.get(arm.id()).outcome())
                .isEqualTo(new Outcome.Refused("gate", "It is already armed."));
    }

    @Test
    void stopsWithWhatItWasSetFor() {
        CommandRecord arm = arms("arm-00001");
        rule(SetCloudLoss.class);
        hear(new DroneEvent.ModeHeard("GUIDED", false));

        apply(new LeaseEvent.TakeOver("sue", "supervisor"));
        until(() -> commands.records.get(arm.id()).outcome() != null);

        assertThat(commands.records.get(arm.id()).outcome()).isInstanceOf(Outcome.Superseded.class);
        assertThat(vehicle.cancelled).isNotEmpty();
        assertThat(vehicle.performed).noneMatch(Command.Arm.class::isInstance);
    }

    @Test
    void isNoLongerWaitedForAfterAStandstill() {
        CommandRecord arm = arms("arm-00001");
        rule(SetCloudLoss.class);

        stalling.stall(Duration.ofSeconds(20));
        until(() -> commands.records.get(arm.id()).outcome() != null);

        assertThat(commands.records.get(arm.id()).outcome()).isInstanceOf(Outcome.Unknown.class);
        assertThat(vehicle.performed).noneMatch(Command.Arm.class::isInstance);
    }

    @Test
    void putsItBackOnceNobodyHasControlOfItAndItStands() {
        wasUsed();

        PutBack command = rule(PutBack.class);
        assertThat(command.values()).containsExactly(VALUE);
        assertThat(owners.kept).containsKey(link.id());
        ruleReport(PutBack.class).ended(new Outcome.Succeeded());
        until(owners.kept::isEmpty);

        assertThat(shown()).isEqualTo(CloudLossState.UNKNOWN);
        arms("arm-00002");
        rule(SetCloudLoss.class);
    }

    @Test
    void putsNothingBackInTheAirWhoeverHasControl() {
        wasUsed();
        hear(new DroneEvent.ModeHeard("AUTO", true));
        hear(new DroneEvent.PhaseHeard(FlightPhase.IN_AIR));

        Steps.throughout(
                time, Duration.ofSeconds(60), () -> vehicle.performed.stream().noneMatch(PutBack.class::isInstance));

        landed();
        rule(PutBack.class);
    }

    @Test
    void putsNothingBackWhileSomebodyHasControl() {
        wasUsed();
        apply(new LeaseEvent.Take("ann"));

        Steps.throughout(time, Duration.ofSeconds(30), () -> {
            apply(new LeaseEvent.Heartbeat("ann", control().epoch()));
            return vehicle.performed.isEmpty();
        });
    }

    @Test
    void writesNoMoreBackWhenAPilotArmsIt() {
        wasUsed();
        rule(PutBack.class);

        hear(new DroneEvent.ModeHeard("LOITER", true));

        until(() -> !vehicle.cancelled.isEmpty());
        assertThat(owners.kept).containsKey(link.id());
    }

    @Test
    void triesAgainAMinuteLaterAndSaysSoOnce() {
        wasUsed();
        ruleReport(PutBack.class).ended(new Outcome.TimedOut("The vehicle did not tell it."));
        long failed = time.nanos();
        vehicle.performed.clear();

        assertThat(time.advanceUntil(() -> !vehicle.performed.isEmpty(), Duration.ofMinutes(2)))
                .isTrue();

        assertThat(Duration.ofNanos(time.nanos() - failed)).isGreaterThan(Duration.ofSeconds(59));
        ruleReport(PutBack.class).ended(new Outcome.TimedOut("The vehicle did not tell it."));
        time.settle();
        assertThat(owners.kept).containsKey(link.id());
        assertThat(told())
                .filteredOn(text -> text.contains("could not be put back yet"))
                .hasSize(1);
    }

    @Test
    void tellsWhatSomebodyElseHasChangedAndDropsIt() {
        wasUsed();
        rule(PutBack.class).keeper().leftAlone(List.of(new ParameterValue("FS_GCS_ENABLE", 5)));
        ruleReport(PutBack.class).ended(new Outcome.Succeeded());
        until(owners.kept::isEmpty);

        assertThat(told())
                .contains("FS_GCS_ENABLE = 5 was changed by somebody else meanwhile, so it stays; its owner had set"
                        + " FS_GCS_ENABLE = 0.");
    }

    @Test
    void givesWayToWhoArmsItWhileItIsPutBack() {
        wasUsed();
        rule(PutBack.class);

        arms("arm-00002");

        assertThat(rule(SetCloudLoss.class).kept()).containsExactly(VALUE);
        assertThat(vehicle.cancelled).isNotEmpty();
    }

    @Test
    void knowsTheOwnersValuesAfterACrashBeforeTheyWereWritten() {
        arms("arm-00001");
        keeps(rule(SetCloudLoss.class), VALUE);
        vehicle.performed.clear();

        CloudManager next = cloud();
        link = bound(next);
        hear(new DroneEvent.Identified(Fixtures.copter(null), MODES));
        landed();
        next.gate().submit(ANN, link.id(), id("arm-00002"), new Command.Arm());

        assertThat(rule(SetCloudLoss.class).kept()).containsExactly(VALUE);
    }

    @Test
    void putsThemBackAfterACrashBeforeThat() {
        wasUsed();

        CloudManager next = cloud();
        assertThat(next.cloudLoss(link.id()).outstanding()).containsExactly(VALUE);
        link = bound(next);
        hear(new DroneEvent.Identified(Fixtures.copter(null), MODES));
        landed();

        assertThat(rule(PutBack.class).values()).containsExactly(VALUE);
    }

    @Test
    void doesNotReadTheHeightOfARunForTheOwnersAfterACrash() {
        wasUsed();

        CloudManager next = cloud();
        link = bound(next);
        hear(new DroneEvent.Identified(Fixtures.copter(null), MODES));
        landed();
        next.gate().submit(ANN, link.id(), id("height-02"), new SetReturnHeight(20, false));

        until(() -> !vehicle.performed.isEmpty());
        assertThat(vehicle.performed).containsExactly(new SetReturnHeight(20, false));
    }

    @Test
    void listsWhatIsOutstandingOnADroneThatWasRemoved() {
        OwnersValues left = new OwnersValues(new DroneId("gone-1"), "Falcon", BEGAN, 15.0, true, List.of(VALUE));
        owners.kept.put(left.drone(), left);

        CloudManager next = cloud();

        assertThat(next.leftBehind()).containsExactly(left);
        assertThat(cloud.leftBehind()).isEmpty();
    }

    @Test
    void givesTwoThatAreArmedAtTheSameMomentDifferentHeights() {
        Fixtures.RecordingChannel another = new Fixtures.RecordingChannel();
        another.settlesAtOnce = false;
        LinkSession session =
                new LinkSession(new DroneKey("127.0.0.1", 14602, 2), "udp", false, "ArduCopter 2", another);
        DroneLink second = Fixtures.bound(cloud.admit(new Claim(session, Fixtures.copter(null), null, true, 0)));
        second.lane().execute(() -> {
            second.accept(new DroneEvent.Identified(Fixtures.copter(null), MODES));
            second.accept(new DroneEvent.ModeHeard("GUIDED", false));
            second.accept(new DroneEvent.PhaseHeard(FlightPhase.ON_GROUND));
        });
        time.settle();

        arms("arm-00001");
        gate.submit(BOB, second.id(), id("arm-00002"), new Command.Arm());
        until(() -> !another.performed.isEmpty());

        assertThat(rule(SetCloudLoss.class).keeper().returnMeters(15)).isEqualTo(15);
        assertThat(((SetCloudLoss) another.performed.get(0)).keeper().returnMeters(15))
                .isEqualTo(20);
    }
}
