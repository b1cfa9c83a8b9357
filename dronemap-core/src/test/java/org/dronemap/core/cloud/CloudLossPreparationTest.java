package org.dronemap.core.cloud;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.SetCloudLossAction;
import org.dronemap.core.command.SetReturnHeight;
import org.dronemap.core.drone.CloudLossState;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.ReturnHeight;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.lease.LeaseEvent;
import org.junit.jupiter.api.Test;

/** What a drone does without the cloud is set before it is armed from here. */
class CloudLossPreparationTest extends CloudLossTestBase {
    @Test
    void setsItBeforeItIsArmedAndKeepsWhatItsOwnerHadFirst() {
        CommandRecord arm = arms("arm-00001");
        SetCloudLossAction command = rule(SetCloudLossAction.class);
        assertThat(vehicle.performed).containsExactly(command);
        assertThat(command.afterSeconds()).isEqualTo(20);

        assertThat(keeps(command, VALUE)).isCompleted();
        assertThat(owners.kept.get(link.id()).values()).containsExactly(VALUE);
        assertThat(owners.kept.get(link.id()).written()).isFalse();
        assertThat(vehicle.performed).hasSize(1);
        ruleReport(SetCloudLossAction.class).ended(new Outcome.Succeeded());
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
        keeps(rule(SetCloudLossAction.class), VALUE);
        ruleReport(SetCloudLossAction.class).ended(new Outcome.Failed("The vehicle did not take it."));

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

        assertThat(keeps(rule(SetCloudLossAction.class), VALUE)).isCompletedExceptionally();
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
        rule(SetCloudLossAction.class);

        hear(new DroneEvent.ModeReported("GUIDED", true));
        until(() -> commands.records.get(arm.id()).outcome() != null);

        assertThat(vehicle.cancelled).hasSize(1);
        assertThat(commands.records.get(arm.id()).outcome())
                .isEqualTo(new Outcome.Refused("gate", "It is already armed.", OutcomeCode.ALREADY_ARMED));
    }

    @Test
    void stopsWithWhatItWasSetFor() {
        CommandRecord arm = arms("arm-00001");
        rule(SetCloudLossAction.class);
        hear(new DroneEvent.ModeReported("GUIDED", false));

        apply(new LeaseEvent.TakeOver("sue", "supervisor"));
        until(() -> commands.records.get(arm.id()).outcome() != null);

        assertThat(commands.records.get(arm.id()).outcome()).isInstanceOf(Outcome.Superseded.class);
        assertThat(vehicle.cancelled).isNotEmpty();
        assertThat(vehicle.performed).noneMatch(Command.Arm.class::isInstance);
    }

    @Test
    void isNoLongerWaitedForAfterAStandstill() {
        CommandRecord arm = arms("arm-00001");
        rule(SetCloudLossAction.class);

        stalling.stall(Duration.ofSeconds(20));
        until(() -> commands.records.get(arm.id()).outcome() != null);

        assertThat(commands.records.get(arm.id()).outcome()).isInstanceOf(Outcome.Unknown.class);
        assertThat(vehicle.performed).noneMatch(Command.Arm.class::isInstance);
    }

    @Test
    void knowsTheOwnersValuesAfterACrashBeforeTheyWereWritten() {
        arms("arm-00001");
        keeps(rule(SetCloudLossAction.class), VALUE);
        vehicle.performed.clear();

        CloudManager next = cloud();
        link = bound(next);
        hear(new DroneEvent.Identified(CloudFixtures.copter(null), MODES));
        landed();
        next.gate().submit(ANN, link.id(), id("arm-00002"), new Command.Arm());

        assertThat(rule(SetCloudLossAction.class).kept()).containsExactly(VALUE);
    }

    @Test
    void knowsHowHighItFliesHomeAfterACrashToo() {
        wasUsed();
        assertThat(returnHeight(cloud)).isEqualTo(new ReturnHeight(15, 15));

        hear(new DroneEvent.ReturnHeightSet(new ReturnHeight(40, 15)));
        assertThat(shown().returnMeters()).isEqualTo(40);

        CloudManager next = cloud();
        link = bound(next);
        assertThat(returnHeight(next)).isEqualTo(new ReturnHeight(40, 40));
    }

    private ReturnHeight returnHeight(CloudManager at) {
        return at.drone(link.id()).orElseThrow().returnHeight();
    }

    @Test
    void givesTwoThatAreArmedAtTheSameMomentDifferentHeights() {
        CloudFixtures.RecordingChannel another = new CloudFixtures.RecordingChannel();
        another.settlesAtOnce = false;
        LinkSession session =
                new LinkSession(new DroneKey("127.0.0.1", 14602, 2), "udp", false, "ArduCopter 2", another);
        DroneLink second =
                CloudFixtures.bound(cloud.admit(new Claim(session, CloudFixtures.copter(null), null, true, 0)));
        second.lane().execute(() -> {
            second.accept(new DroneEvent.Identified(CloudFixtures.copter(null), MODES));
            second.accept(new DroneEvent.ModeReported("GUIDED", false));
            second.accept(new DroneEvent.PhaseReported(FlightPhase.ON_GROUND));
        });
        time.settle();

        arms("arm-00001");
        gate.submit(BOB, second.id(), id("arm-00002"), new Command.Arm());
        until(() -> !another.performed.isEmpty());

        assertThat(rule(SetCloudLossAction.class).keeper().returnMeters(15)).isEqualTo(15);
        assertThat(((SetCloudLossAction) another.performed.get(0)).keeper().returnMeters(15))
                .isEqualTo(30);
    }
}
