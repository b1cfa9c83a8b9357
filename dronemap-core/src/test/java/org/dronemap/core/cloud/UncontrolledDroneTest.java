package org.dronemap.core.cloud;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.core.lease.SavedLease;
import org.dronemap.core.mission.MissionItem;
import org.junit.jupiter.api.Test;

/** However control ends in the air: whoever is left alone comes home, unless somebody takes it or a pilot has it. */
class UncontrolledDroneTest extends GuidedFlightTestBase {
    private void comesHome() {
        until(() -> vehicle.performed.contains(new Command.ReturnToLaunch()));
    }

    private List<String> told() {
        DroneState now = cloud.drone(link.id()).orElseThrow();
        return now.messages().stream().map(message -> message.text()).toList();
    }

    @Test
    void comesHomeWhenControlThatCameWithACommandIsOver() {
        isCommandedBy(ANN);

        until(() -> changes.contains(ControlChange.Kind.EXPIRED));
        until(() -> told().contains("Nobody has control of it now: it returns in 1 s unless somebody takes control."));
        comesHome();
        assertThat(vehicle.performed).containsExactly(new Command.ReturnToLaunch());
    }

    @Test
    void comesHomeWhenItWasHandedToSomebodyWhoIsNotThere() {
        isCommandedBy(ANN);
        apply(new LeaseEvent.TakeControl("ann"));
        apply(new LeaseEvent.HandOver("ann", "bob"));

        comesHome();
    }

    @Test
    void comesHomeWhenItsHolderGivesItBackOrMayNoMore() {
        isCommandedBy(ANN);
        apply(new LeaseEvent.TakeControl("ann"));
        apply(new LeaseEvent.Release("ann"));
        comesHome();
        vehicle.performed.clear();

        isCommandedBy(ANN);
        apply(new LeaseEvent.Expel("ann"));
        comesHome();
    }

    @Test
    void staysWithWhoeverTakesItInTime() {
        isCommandedBy(ANN);
        apply(new LeaseEvent.TakeControl("ann"));
        apply(new LeaseEvent.Release("ann"));
        apply(new LeaseEvent.TakeControl("bob"));

        SteppedUntil.throughout(time, Duration.ofSeconds(3), () -> {
            apply(new LeaseEvent.Heartbeat("bob", control().epoch()));
            return vehicle.performed.isEmpty();
        });
    }

    @Test
    void staysWithItsHolderAsLongAsTheHolderLooks() {
        AtomicBoolean looks = new AtomicBoolean(true);
        cloud.controls().watchedBy((user, drone) -> user.equals("ann") && drone.equals(link.id()) && looks.get());
        isCommandedBy(ANN);
        SteppedUntil.throughout(time, Duration.ofSeconds(10), vehicle.performed::isEmpty);
        assertThat(control().isHeldBy("ann")).isTrue();

        looks.set(false);
        comesHome();
    }

    @Test
    void isThePilotsWhoTakesIt() {
        isCommandedBy(ANN);
        until(() -> changes.contains(ControlChange.Kind.EXPIRED));
        hear(new DroneEvent.ModeReported("LOITER", true));

        SteppedUntil.throughout(time, Duration.ofSeconds(5), vehicle.performed::isEmpty);
    }

    @Test
    void fliesItsMissionToTheEndAndThenComesHome() {
        List<MissionItem> items = List.of(new MissionItem.TakeOff(20));
        hear(new DroneEvent.MissionRead(items, null, true));
        isCommandedBy(ANN);
        CommandRecord start = gate.submit(ANN, link.id(), id("start-001"), new Command.SetMode("AUTO"));
        VehicleChannel.Report report = report(start);
        hear(new DroneEvent.ModeReported("AUTO", true));
        report.ended(new Outcome.Succeeded());
        vehicle.performed.clear();
        until(() -> changes.contains(ControlChange.Kind.EXPIRED));
        SteppedUntil.throughout(time, Duration.ofSeconds(5), vehicle.performed::isEmpty);

        hear(new DroneEvent.MissionItemReached(0));

        comesHome();
    }

    @Test
    void comesHomeAfterACrashInTheMiddleOfPlainCommands() {
        isCommandedBy(ANN);
        until(() -> leases.leases.values().stream().anyMatch(SavedLease::lapsed));

        link = bound(cloud());
        hoverInGuided();

        comesHome();
    }

    @Test
    void isLeftToWhoeverTookItWhileTheServerWasAway() {
        isCommandedBy(ANN);
        until(() -> leases.leases.values().stream().anyMatch(lease -> "GUIDED".equals(lease.mode())));

        CloudFixtures.RecordingChannel later = new CloudFixtures.RecordingChannel();
        LinkSession session = new LinkSession(new DroneKey("127.0.0.1", 14601, 1), "udp", false, "ArduCopter 1", later);
        CloudManager again = cloud();
        link = CloudFixtures.bound(again.admit(new Claim(session, CloudFixtures.copter(null), null, true, 0)));
        hear(new DroneEvent.Identified(CloudFixtures.copter(null), MODES));
        hear(new DroneEvent.ModeReported("LOITER", true));
        hear(new DroneEvent.PhaseReported(FlightPhase.IN_AIR));

        SteppedUntil.throughout(time, Duration.ofSeconds(10), later.performed::isEmpty);
        assertThat(again.controls().control(link.id()).lapse()).isNull();
    }

    @Test
    void comesHomeWhenAnOperationThatWentOnAfterARestartEndsInTheAir() {
        LeaseHolder.Operation run = new LeaseHolder.Operation("run-1", "ann", "The run");
        apply(new LeaseEvent.Engage(run));
        apply(new LeaseEvent.Disengage("run-1"));

        comesHome();
    }

    @Test
    void isThePilotsWhomAnOperationGivesWayTo() {
        LeaseHolder.Operation run = new LeaseHolder.Operation("run-1", "ann", "The run");
        apply(new LeaseEvent.Engage(run));
        hear(new DroneEvent.ModeReported("LOITER", true));
        apply(new LeaseEvent.Disengage("run-1"));

        SteppedUntil.throughout(time, Duration.ofSeconds(5), vehicle.performed::isEmpty);
    }
}
