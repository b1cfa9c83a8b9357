package org.dronemap.core.conduct;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.time.Instant;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CommandGate;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.operation.JournalEntry;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.OperationKind;
import org.dronemap.core.operation.OperationObjection;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.organisation.OrganisationId;
import org.junit.jupiter.api.Test;

class OperationsTest extends OperationTestBase {
    @Test
    void commandsUnderItsOwnControlAsWhoeverStartedIt() {
        begin();
        assertThat(isHeldByIt(link.id())).isTrue();

        wish("arm");
        end(FIRST, new Outcome.Succeeded());

        await().until(() -> heard().contains("ended command-1 Succeeded"));
        CommandRecord record = commands.records.get(FIRST);
        assertThat(record.by()).isEqualTo("ann");
        assertThat(record.face()).isEqualTo("operation");
        assertThat(told).contains("It heard ended command-1 Succeeded");
        assertReplays();
    }

    @Test
    void writesADecisionDownBeforeItsCommandsGoOut() {
        begin();
        store.away = true;

        assertThatThrownBy(() -> wish("arm")).hasMessage("the disk is full");

        assertThat(vehicle.performed).isEmpty();
        assertThat(commands.records).isEmpty();
        store.away = false;
        wish("arm");
        await().until(() -> vehicle.performed.size() == 1);
        assertThat(store.operations.get(ID).given()).containsExactly(new SavedOperation.Given(link.id(), FIRST));
    }

    @Test
    void beginsNoOperationOfAKindThatNobodyConducts() {
        OperationKind<ArmingOperation.State, String> forgotten =
                new OperationKind<>("forgotten", ArmingOperation.KIND.machine(), ArmingOperation.KIND.codec());
        SavedOperation begun = SavedOperation.begun(
                ID,
                forgotten.name(),
                new SavedOperation.Owner("ann", "ann", OrganisationId.HOME),
                "a watch",
                Instant.now());

        assertThatThrownBy(() -> operations.begin(forgotten, begun, ArmingOperation.of(link.id())))
                .isInstanceOf(Operations.Refused.class)
                .hasMessageContaining("does not conduct operations of the kind forgotten");

        assertThat(store.operations).isEmpty();
    }

    @Test
    void writesNothingDownOfWhatChangesNothing() {
        begin();
        wish("nothing");
        wish("note something");

        assertThat(store.journal).extracting(JournalEntry::input).containsExactly("drone-1||0|false", "note something");
    }

    @Test
    void losesNoEndOfACommandWhileTheStoreIsAwayAndSaysThatItIs() {
        begin();
        wish("arm");
        await().until(() -> vehicle.reports.containsKey(FIRST));
        store.away = true;

        end(FIRST, new Outcome.Failed("no"));

        await().until(() -> !operations.troubles().isEmpty());
        assertThat(operations.troubles()).containsExactly("“a watch” does not go on: the disk is full");
        assertThat(operations.failedCount()).isPositive();
        assertThat(heard()).isEmpty();
        store.away = false;
        await().until(() -> heard().equals(List.of("ended command-1 Failed")));
        await().until(() -> operations.troubles().isEmpty());
        assertReplays();
    }

    @Test
    void goesOnFromWhatIsStoredWhenAWriteOnlySeemedToFail() {
        begin();
        store.deceiving = true;

        assertThatThrownBy(() -> wish("arm")).hasMessage("the connection broke");

        await().until(() -> heard().contains("ended command-1 Refused"));
        assertThat(heard()).containsExactly("resumed", "ended command-1 Refused");
        assertThat(vehicle.performed).isEmpty();
        assertReplays();
    }

    @Test
    void beginsNothingThatCannotBeWrittenDown() {
        store.deceiving = true;

        assertThatThrownBy(this::begin).hasMessage("the connection broke");

        assertThat(isHeldByIt(link.id())).isFalse();
        assertThat(operations.underWay(ArmingOperation.KIND)).isEmpty();
        await().until(() -> store.operations.isEmpty());
    }

    @Test
    void isTakenUpAfterARestartBeforeAnybodyElseCanCommand() {
        begin();
        wish("arm");
        await().until(() -> vehicle.performed.size() == 1);

        restart();

        assertThat(isHeldByIt(link.id())).isTrue();
        CommandRecord refused = cloud.gate()
                .submit(
                        new CommandGate.Source(new Principal("bob", Role.OPERATOR), "rest"),
                        link.id(),
                        new CommandId("bobs-command"),
                        new Command.Arm());
        assertThat(refused.outcome()).isInstanceOf(Outcome.Refused.class);
        await().until(() -> heard().size() == 2);
        assertThat(heard()).containsExactly("resumed", "ended command-1 Unknown");
        assertReplays();
    }

    /** Before that nobody can be heard, and who is not heard would be missed. */
    @Test
    void goesOnAfterARestartWhenVehiclesAreLetIn() {
        begin();
        restartDeaf();
        await().until(() -> isHeldByIt(link.id()));
        assertThat(heard()).isEmpty();

        operations.goOn();

        await().until(() -> !heard().isEmpty());
        assertThat(heard()).containsExactly("resumed");
        assertReplays();
    }

    @Test
    void tellsOfCommandsThatWereWrittenDownAndNeverSent() {
        begin();
        commands.broken = true;
        wish("arm");
        // Whether it was sent is known as soon as that can be looked up.
        commands.broken = false;

        await().until(() -> heard().contains("ended command-1 Refused"));
        assertThat(vehicle.performed).isEmpty();
    }

    @Test
    void doesNotBeginWithADroneThatSomebodyHas() {
        cloud.controls().apply(link.id(), new LeaseEvent.TakeControl("bob"));

        assertThatThrownBy(this::begin)
                .isInstanceOfSatisfying(
                        Operations.NoControl.class,
                        held -> assertThat(held.why()).contains("drone-1", "bob has had control"));

        assertThat(store.operations).isEmpty();
        assertThat(cloud.controls().control(link.id()).isHeldBy("bob")).isTrue();
    }

    @Test
    void hearsOfWhatItHadWorkedOut() {
        begin();

        wish("compute 42");

        await().until(() -> heard().equals(List.of("asked", "42")));
        assertReplays();
    }

    @Test
    void hearsThatThereIsNoRoomForWorkingSomethingOut() {
        ArmingOperation.TestComputation.mayEnd = new CountDownLatch(1);
        begin();

        for (int i = 0; i < 19; i++) {
            wish("compute " + i);
        }

        await().until(() -> heard().contains("failed: Too much is being worked out already."));
        ArmingOperation.TestComputation.mayEnd.countDown();
        await().until(() -> heard().contains("17"));
    }

    @Test
    void refusesWhatItDoesNotTake() {
        begin();

        assertThatThrownBy(() -> wish("no"))
                .isInstanceOfSatisfying(
                        Operations.Refused.class,
                        refused -> assertThat(refused.why()).isEqualTo("Not that."));
        assertThat(store.journal).hasSize(1);
    }

    @Test
    void givesItsDronesBackWhenItIsOver() {
        begin();

        wish("stop");

        assertThat(isHeldByIt(link.id())).isFalse();
        assertThat(operations.underWay(ArmingOperation.KIND)).isEmpty();
        assertThat(operations
                        .find(ArmingOperation.KIND, ID)
                        .orElseThrow()
                        .saved()
                        .endedAt())
                .isNotNull();
        assertThatThrownBy(() -> wish("arm"))
                .isInstanceOfSatisfying(
                        Operations.Refused.class,
                        refused -> assertThat(refused.objection().code()).isEqualTo(OperationObjection.OVER));
    }

    @Test
    void conductsTheOthersWhenOneCannotBeRead() {
        begin();
        SavedOperation broken = SavedOperation.begun(
                new OperationId("w0"),
                ArmingOperation.KIND.name(),
                new SavedOperation.Owner("bob", "bob", OrganisationId.HOME),
                "broken",
                Instant.now().minusSeconds(60));
        store.operations.put(broken.id(), broken);

        restart();

        await().until(() -> heard().contains("resumed"));
        await().until(() -> store.operations.get(broken.id()).endedAt() != null);
    }
}
