package org.dronemap.core.conduct;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.time.Instant;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.operation.JournalEntry;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.organisation.OrganisationId;
import org.junit.jupiter.api.Test;

/** Operations that cannot go on, or shall not, and what becomes of their drones. */
class FaultedOperationsTest extends OperationTestBase {
    private static final String WHY = "The server ended three times.";

    /** In the air in a mode that waits for orders. */
    private void flies() {
        hear(new DroneEvent.ModeReported("GUIDED", true));
        hear(new DroneEvent.PhaseReported(FlightPhase.IN_AIR));
    }

    private void lands() {
        hear(new DroneEvent.PhaseReported(FlightPhase.ON_GROUND));
        hear(new DroneEvent.ModeReported("RTL", false));
    }

    private SavedOperation stored() {
        return store.find(ID).orElseThrow();
    }

    private boolean isCalledHome() {
        return vehicle.performed.contains(new Command.ReturnToLaunch());
    }

    @Test
    void theirDronesGoHomeAndThenTheyAreOver() {
        begin();
        wish("note flying");
        flies();

        restartWithout(WHY);

        assertThat(operations.find(ArmingOperation.KIND, ID).orElseThrow().setAside())
                .isEqualTo(WHY);
        assertThat(operations.underWay(ArmingOperation.KIND)).isEmpty();
        assertThat(operations.setAside(ArmingOperation.KIND)).hasSize(1);
        assertThat(operations.troubles()).containsExactly("The operation w1 is set aside. " + WHY);
        assertThat(isHeldByIt(link.id())).isTrue();

        callIn(FlightPhase.IN_AIR);
        await().until(this::isCalledHome);
        assertThat(stored().endedAt()).isNull();

        lands();
        await().until(() -> stored().endedAt() != null);
        assertThat(isHeldByIt(link.id())).isFalse();
        await().until(() -> operations.troubles().isEmpty());
        assertThat(operations.find(ArmingOperation.KIND, ID).orElseThrow().setAside())
                .startsWith("The server set it aside");
        assertReplays();
    }

    @Test
    void anOrdinaryStartDoesNotTakeThemUpAgain() {
        begin();
        flies();
        restartWithout(WHY);

        restart();

        assertThat(operations.underWay(ArmingOperation.KIND)).isEmpty();
        callIn(FlightPhase.IN_AIR);
        await().until(this::isCalledHome);
    }

    @Test
    void aDroneThatSomebodyHasIsLeftToHim() {
        begin();
        cloud.controls().apply(link.id(), new LeaseEvent.TakeOver("bob", "look out"));
        flies();

        restartWithout(WHY);
        callIn(FlightPhase.IN_AIR);

        await().until(() -> stored().endedAt() != null);
        assertThat(isCalledHome()).isFalse();
    }

    @Test
    void whatCannotBeReadIsSetAsideAndItsDronesGoHome() {
        begin();
        flies();
        store.operations.computeIfPresent(
                ID, (id, saved) -> saved.next("drone-1 in no state at all", saved.given(), null));
        store.journal.add(new JournalEntry(1, Instant.now(), "note odd", ""));

        restart();
        callIn(FlightPhase.IN_AIR);

        await().until(this::isCalledHome);
        assertThat(operations.troubles())
                .containsExactly("The operation w1 is set aside. It cannot be taken up again: no state of a watch:"
                        + " drone-1 in no state at all");
        lands();
        await().until(() -> stored().endedAt() != null);
        assertThat(operations.find(ArmingOperation.KIND, ID)).isEmpty();
    }

    @Test
    void whatAlwaysFailsIsSetAsideAndOthersGoOn() {
        begin();
        wish("arm");
        await().until(() -> vehicle.reports.containsKey(FIRST));
        flies();
        OperationId other = new OperationId("w2");
        operations.begin(
                ArmingOperation.KIND,
                SavedOperation.begun(
                        other,
                        "watch",
                        new SavedOperation.Owner("bob", "bob", OrganisationId.HOME),
                        "other",
                        Instant.now()),
                ArmingOperation.of());

        ArmingOperation.poisonous = true;
        end(FIRST, new Outcome.Succeeded());

        await().until(() -> {
            flies();
            return isCalledHome();
        });
        assertThat(operations.underWay(ArmingOperation.KIND)).hasSize(1);
        lands();
        await().until(() -> stored().endedAt() != null);
    }
}
