package org.dronemap.core.cloud;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dronemap.core.audit.AuditEntry;
import org.dronemap.core.audit.AuditOutcome;
import org.dronemap.core.audit.AuditedCall;
import org.dronemap.core.cloud.lane.Watchdog;
import org.dronemap.core.cloud.listener.CloudListener;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.lease.ControlState;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.core.lease.SavedLease;
import org.junit.jupiter.api.Test;

/** Control of a drone, from the gate to the wire. */
class ControlEndToEndTest extends GuidedFlightTestBase {
    @Test
    void refusesTheCommandOfOneWhileAnotherHasControl() {
        CommandRecord first = gate.submit(ANN, link.id(), id("first-001"), new Command.SetMode("LOITER"));
        CommandRecord second = gate.submit(BOB, link.id(), id("second-01"), new Command.SetMode("GUIDED"));

        assertThat(first.epoch()).isPositive();
        assertThat(second.outcome())
                .isInstanceOfSatisfying(
                        Outcome.Refused.class,
                        refused -> assertThat(refused.reason()).startsWith("ann has had control of it since 20"));
        until(() -> vehicle.performed.equals(List.of(new Command.SetMode("LOITER"))));
    }

    @Test
    void isFreeForTheNextWhenTheFirstIsIdle() {
        CommandRecord first = gate.submit(ANN, link.id(), id("first-001"), new Command.SetMode("LOITER"));
        report(first).ended(new Outcome.Succeeded());
        until(() -> changes.contains(ControlChange.Kind.EXPIRED));

        CommandRecord second = gate.submit(BOB, link.id(), id("second-01"), new Command.SetMode("GUIDED"));

        assertThat(second.outcome()).isNull();
        assertThat(second.epoch()).isGreaterThan(first.epoch());
    }

    @Test
    void stopsWhatIsUnderWayWhenControlChangesHands() {
        CommandRecord old = gate.submit(ANN, link.id(), id("first-001"), new Command.SetMode("LOITER"));
        EpochGuard fence = vehicle.fences.get(report(old));
        assertThat(fence.isOpen()).isTrue();

        apply(new LeaseEvent.TakeOver("sue", "smoke over there"));

        assertThat(fence.isOpen()).isFalse();
        assertThat(time.join(gate.end(old.id()), PATIENCE).outcome())
                .isInstanceOfSatisfying(
                        Outcome.Superseded.class,
                        superseded -> assertThat(superseded.reason())
                                .startsWith("Control has changed hands. sue has had control"));
        assertThat(vehicle.cancelled).containsExactly(old.id());
        until(() -> cloud.drone(link.id()).orElseThrow().messages().stream()
                .anyMatch(message -> message.text().equals("sue took control over from ann: smoke over there")));
    }

    @Test
    void letsASupervisorLandStopAndCallBackWhateverOthersFly() {
        apply(new LeaseEvent.TakeControl("ann"));
        for (Command safe : List.of(new Command.Hold(), new Command.Land(), new Command.ReturnToLaunch())) {
            CommandRecord given =
                    gate.submit(SUE, link.id(), id("safe-" + safe.summary().replace(' ', '-')), safe);
            assertThat(vehicle.fences.get(report(given)).isOpen()).isTrue();
            apply(new LeaseEvent.TakeControl("ann"));
            assertThat(vehicle.fences.get(report(given)).isOpen()).isTrue();
        }

        assertThat(gate.submit(SUE, link.id(), id("other-001"), new Command.SetMode("LOITER"))
                        .outcome())
                .isInstanceOf(Outcome.Refused.class);
        assertThat(gate.submit(BOB, link.id(), id("other-002"), new Command.Land())
                        .outcome())
                .isInstanceOf(Outcome.Refused.class);
        assertThat(control().isHeldBy("ann")).isTrue();
    }

    @Test
    void letsEverybodyReadWhateverOthersFly() {
        apply(new LeaseEvent.TakeControl("ann"));

        assertThat(gate.submit(BOB, link.id(), id("read-0001"), new Command.ReadParameters())
                        .outcome())
                .isNull();
        assertThat(control().isHeldBy("ann")).isTrue();
    }

    @Test
    void holdsAndThenCallsBackADroneWhoseHolderIsLost() {
        isCommandedBy(ANN);
        apply(new LeaseEvent.TakeControl("ann"));

        until(() -> vehicle.performed.contains(new Command.Hold()));
        until(() -> vehicle.performed.contains(new Command.ReturnToLaunch()));

        assertThat(vehicle.performed).containsExactly(new Command.Hold(), new Command.ReturnToLaunch());
        assertThat(commands.records.values()).allMatch(record -> record.by().equals("dronemap"));
    }

    @Test
    void remembersThatADroneHasToBeCalledBackUntilItIsDown() {
        isCommandedBy(ANN);
        apply(new LeaseEvent.TakeControl("ann"));

        until(() -> leases.leases.values().stream().anyMatch(SavedLease::lapsed));
        until(() -> vehicle.performed.contains(new Command.ReturnToLaunch()));
        assertThat(leases.leases).isNotEmpty();
        isDown();
        until(leases.leases::isEmpty);
    }

    @Test
    void callsADroneBackAfterARestartAsSoonAsItIsHeard() {
        until(() -> !drones.records.isEmpty());
        leases.save(new SavedLease(
                link.id(), "ann", time.clock().instant(), control().epoch(), true));

        CloudManager again = cloud();
        SteppedUntil.throughout(time, Duration.ofSeconds(2), vehicle.performed::isEmpty);
        link = bound(again);
        hoverInGuided();

        until(() -> vehicle.performed.contains(new Command.ReturnToLaunch()));
        assertThat(leases.leases).isNotEmpty();
        isDown();
        until(leases.leases::isEmpty);
    }

    @Test
    void callsNothingBackThatFellSilentBeforeAndIsHeardLater() {
        Duration soon = Duration.ofSeconds(1);
        CloudManager hasty = cloud(new Watchdog(soon, soon, soon));
        List<ControlChange.Kind> seen = new CopyOnWriteArrayList<>();
        hasty.addListener(new CloudListener() {
            @Override
            public void controlChanged(DroneId drone, ControlState now, ControlChange change) {
                seen.add(change.kind());
            }
        });
        link = bound(hasty);
        hoverInGuided();
        hasty.controls().apply(link.id(), new LeaseEvent.TakeControl("ann"));

        until(() -> seen.contains(ControlChange.Kind.RETURN_DUE));
        hear(new DroneEvent.ModeReported("LOITER", true));
        SteppedUntil.throughout(
                time, Duration.ofSeconds(1), () -> !vehicle.performed.contains(new Command.ReturnToLaunch()));
    }

    @Test
    void leavesADroneAloneThatFliesItsMissionWithoutItsHolder() {
        hear(new DroneEvent.ModeReported("AUTO", true));
        apply(new LeaseEvent.TakeControl("ann"));
        until(() -> changes.contains(ControlChange.Kind.LOST));

        SteppedUntil.throughout(time, Duration.ofSeconds(5), vehicle.performed::isEmpty);
    }

    @Test
    void doesNotCallBackWhatSomebodyElseHasTaken() {
        isCommandedBy(ANN);
        apply(new LeaseEvent.TakeControl("ann"));
        until(() -> vehicle.performed.contains(new Command.Hold()));
        apply(new LeaseEvent.TakeControl("bob"));
        SteppedUntil.throughout(time, Duration.ofSeconds(2), () -> {
            apply(new LeaseEvent.Heartbeat("bob", control().epoch()));
            return !vehicle.performed.contains(new Command.ReturnToLaunch());
        });
    }

    @Test
    void givesWayToThePilotAtTheVehicle() {
        apply(new LeaseEvent.TakeControl("ann"));
        awaitTick();
        hear(new DroneEvent.ModeReported("LOITER", true));

        until(() -> control().tenure().holder() instanceof LeaseHolder.Pilot);
        assertThat(gate.submit(ANN, link.id(), id("first-001"), new Command.SetMode("GUIDED"))
                        .outcome())
                .isInstanceOf(Outcome.Refused.class);

        apply(new LeaseEvent.TakeControl("ann"));
        assertThat(gate.submit(ANN, link.id(), id("first-002"), new Command.SetMode("GUIDED"))
                        .outcome())
                .isNull();
    }

    @Test
    void takesNeitherItsOwnCommandsNorAFailSafeForAPilot() {
        CommandRecord asked = gate.submit(ANN, link.id(), id("first-001"), new Command.SetMode("LOITER"));
        report(asked);
        awaitTick();
        hear(new DroneEvent.ModeReported("LOITER", true));
        awaitTick();
        report(asked).ended(new Outcome.Succeeded());
        hear(new DroneEvent.ModeReported("GUIDED", true));
        awaitTick();
        hear(new DroneEvent.TextReported(Severity.WARNING, "EKF Failsafe: changed to LOITER"));
        hear(new DroneEvent.ModeReported("LOITER", true));
        awaitTick();

        assertThat(changes).doesNotContain(ControlChange.Kind.PILOT_ACTED);
    }

    @Test
    void rebuildsExplicitControlAfterARestartWithANewerEpoch() {
        apply(new LeaseEvent.TakeControl("ann"));
        long before = control().epoch();
        until(() -> !drones.records.isEmpty());

        CloudManager again = cloud();

        assertThat(again.controls().control(link.id()).isHeldBy("ann")).isTrue();
        assertThat(again.controls().control(link.id()).epoch()).isGreaterThan(before);
    }

    @Test
    void refusesAClientThatBelievesInControlThatHasEnded() {
        apply(new LeaseEvent.TakeControl("ann"));
        long old = control().epoch();
        apply(new LeaseEvent.TakeControl("ann"));

        CommandRecord stale = gate.submit(
                new CommandGate.Source(ANN.principal(), "rest", old),
                link.id(),
                id("stale-001"),
                new Command.SetMode("LOITER"));

        assertThat(stale.outcome())
                .isInstanceOfSatisfying(
                        Outcome.Refused.class,
                        refused -> assertThat(refused.reason()).startsWith("Control by epoch " + old + " has ended."));
    }

    /** Else the record of a call would be of the control that came with its command, and the command would leave a second. */
    @Test
    void controlThatComesWithACommandIsNotWhatTheCallIsAbout() {
        AuditEntry entry = new AuditEntry(
                BEGAN,
                null,
                null,
                null,
                "soap",
                "takePicture",
                null,
                null,
                null,
                "",
                AuditOutcome.SUCCEEDED,
                null,
                null,
                null);
        AuditedCall call = new AuditedCall(entry, time::nanos);

        var unused = call.during(() -> gate.submit(ANN, link.id(), id("picture-1"), new Command.TakePicture()));
        until(() -> !leases.leases.isEmpty());

        assertThat(leases.ofCalls).hasValue(0);
    }
}
