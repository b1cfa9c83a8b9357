package org.dronemap.core.conduct;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.util.Optional;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CommandGate;
import org.dronemap.core.cloud.listener.CloudListener;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandPhase;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.lease.LeaseEvent;
import org.junit.jupiter.api.Test;

/** Drones that somebody takes from an operation, or whose owner may no longer command them. */
class InterruptedOperationsTest extends OperationTestBase {
    @Test
    void seesWhoTookADroneAndGivesUpItsControl() {
        begin();

        cloud.controls().apply(link.id(), new LeaseEvent.TakeOver("bob", "look out"));

        await().until(() -> heard().stream().anyMatch(one -> one.startsWith("taken bob has had control of it")));
        assertThat(operations
                        .find(ArmingOperation.KIND, ID)
                        .orElseThrow()
                        .state()
                        .drones())
                .isEmpty();
        assertThat(cloud.controls().control(link.id()).isHeldBy("bob")).isTrue();
    }

    @Test
    void doesNotTakeBackADroneThatBecomesFreeAgain() {
        begin();
        cloud.controls().apply(link.id(), new LeaseEvent.PilotActed("LOITER"));
        cloud.controls().apply(link.id(), new LeaseEvent.PilotLeft());
        // What is decided meanwhile must not ask for it again.
        wish("note something");

        await().until(() -> heard().stream().anyMatch(one -> one.startsWith("taken")));

        assertThat(isHeldByIt(link.id())).isFalse();
    }

    @Test
    void letsGoOfADroneThatASupervisorBringsDown() {
        begin();
        hear(new DroneEvent.ModeReported("GUIDED", true));
        hear(new DroneEvent.PhaseReported(FlightPhase.IN_AIR));

        cloud.gate()
                .submit(
                        new CommandGate.Source(new Principal("sue", Role.SUPERVISOR), "rest"),
                        link.id(),
                        new CommandId("sue-lands-it"),
                        new Command.Land());

        await().until(() -> heard().contains("taken sue told the drone: land."));
        assertThat(isHeldByIt(link.id())).isFalse();
    }

    @Test
    void actsNoMoreOnceASupervisorWentFirstThoughItsCommandWasOnItsWay() {
        begin();
        hear(new DroneEvent.ModeReported("GUIDED", true));
        hear(new DroneEvent.PhaseReported(FlightPhase.IN_AIR));
        cloud.addListener(new CloudListener() {
            @Override
            public void commandChanged(CommandRecord command) {
                if (command.id().equals(FIRST) && command.phase() == CommandPhase.SENT && command.outcome() == null) {
                    cloud.gate()
                            .submit(
                                    new CommandGate.Source(new Principal("sue", Role.SUPERVISOR), "rest"),
                                    link.id(),
                                    new CommandId("sue-stops-it"),
                                    new Command.Hold());
                }
            }
        });

        wish("home");

        await().until(() -> heard().contains("ended command-1 Superseded"));
        assertThat(vehicle.performed).containsExactly(new Command.Hold());
        assertThat(heard()).contains("taken sue told the drone: hold.");
        assertThat(commands.records.get(FIRST).outcome())
                .isEqualTo(new Outcome.Superseded(
                        "Control has changed hands. sue told the drone: hold. Nobody has control;" + " take it."));
    }

    @Test
    void losesDronesThatItsOwnerMayNoLongerCommand() {
        begin();
        rights.set(Optional.of("ann may not command it any more."));

        await().until(() -> heard().contains("taken ann may not command it any more."));
    }
}
