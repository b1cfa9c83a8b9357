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
import org.dronemap.core.lease.Holder;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.lease.SavedLease;
import org.dronemap.core.mission.MissionItem;
import org.junit.jupiter.api.Test;

/** However control ends in the air: whoever is left alone comes home, unless somebody takes it or a pilot has it. */
class NobodysDroneTest extends GuidedFlight {
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
        apply(new LeaseEvent.Take("ann"));
        apply(new LeaseEvent.HandOver("ann", "bob"));

        comesHome();
    }

    @Test
    void comesHomeWhenItsHolderGivesItBackOrMayNoMore() {
        isCommandedBy(ANN);
        apply(new LeaseEvent.Take("ann"));
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
        apply(new LeaseEvent.Take("ann"));
        apply(new LeaseEvent.Release("ann"));
        apply(new LeaseEvent.Take("bob"));

        Steps.throughout(time, Duration.ofSeconds(3), () -> {
            apply(new LeaseEvent.Heartbeat("bob", control().epoch()));
            return vehicle.performed.isEmpty();
        });
    }

    @Test
    void staysWithItsHolderAsLongAsTheHolderLooks() {
        AtomicBoolean looks = new AtomicBoolean(true);
        cloud.controls().watchedBy((user, drone) -> user.equals("ann") && drone.equals(link.id()) && looks.get());
        isCommandedBy(ANN);
        Steps.throughout(time, Duration.ofSeconds(10), vehicle.performed::isEmpty);
        assertThat(control().isHeldBy("ann")).isTrue();

        looks.set(false);
        comesHome();
    }

    @Test
    void isThePilotsWhoTakesIt() {
        isCommandedBy(ANN);
        until(() -> changes.contains(ControlChange.Kind.EXPIRED));
        hear(new DroneEvent.ModeHeard("LOITER", true));

        Steps.throughout(time, Duration.ofSeconds(5), vehicle.performed::isEmpty);
    }

    @Test
    void fliesItsMissionToTheEndAndThenComesHome() {
        List<MissionItem> items = List.of(new MissionItem.TakeOff(20));
        hear(new DroneEvent.MissionRead(items, null, true));
        isCommandedBy(ANN);
        CommandRecord start = gate.submit(ANN, link.id(), id("start-001"), new Command.SetMode("AUTO"));
        VehicleChannel.Report report = report(start);
        hear(new DroneEvent.ModeHeard("AUTO", true));
        report.ended(new Outcome.Succeeded());
        vehicle.performed.clear();
        until(() -> changes.contains(ControlChange.Kind.EXPIRED));
        Steps.throughout(time, Duration.ofSeconds(5), vehicle.performed::isEmpty);

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

        Fixtures.RecordingChannel later = new Fixtures.RecordingChannel();
        LinkSession session = new LinkSession(new DroneKey("127.0.0.1", 14601, 1), "udp", false, "ArduCopter 1", later);
        CloudManager again = cloud();
        link = Fixtures.bound(again.admit(new Claim(session, Fixtures.copter(null), null, true, 0)));
        hear(new DroneEvent.Identified(Fixtures.copter(null), MODES));
        hear(new DroneEvent.ModeHeard("LOITER", true));
        hear(new DroneEvent.PhaseHeard(FlightPhase.IN_AIR));

        Steps.throughout(time, Duration.ofSeconds(10), later.performed::isEmpty);
        assertThat(again.controls().control(link.id()).lapse()).isNull();
    }

    @Test
    void comesHomeWhenAnOperationThatWentOnAfterARestartEndsInTheAir() {
        Holder.Operation run = new Holder.Operation("run-1", "ann", "The run");
        apply(new LeaseEvent.Engage(run));
        apply(new LeaseEvent.Disengage("run-1"));

        comesHome();
    }

    @Test
    void isThePilotsWhomAnOperationGivesWayTo() {
        Holder.Operation run = new Holder.Operation("run-1", "ann", "The run");
        apply(new LeaseEvent.Engage(run));
        hear(new DroneEvent.ModeHeard("LOITER", true));
        apply(new LeaseEvent.Disengage("run-1"));

        Steps.throughout(time, Duration.ofSeconds(5), vehicle.performed::isEmpty);
    }
}
