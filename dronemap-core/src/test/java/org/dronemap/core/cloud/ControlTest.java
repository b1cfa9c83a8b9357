package org.dronemap.core.cloud;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.lease.Control;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.lease.Holder;
import org.dronemap.core.lease.LeaseAnswer;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.lease.LeaseRules;
import org.dronemap.core.lease.SavedLease;
import org.dronemap.core.time.SteppedTime;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Control of a drone, from the gate to the wire. */
class ControlTest {
    private static final CommandGate.Source ANN = operator("ann");
    private static final CommandGate.Source BOB = operator("bob");
    private static final CommandGate.Source SUE = new CommandGate.Source(new Principal("sue", Role.SUPERVISOR), "rest");
    private static final Instant BEGAN = Instant.parse("2026-03-04T05:06:07Z");
    private static final Duration PATIENCE = Duration.ofSeconds(30);
    /** As quick as it may be. */
    private static final LeaseRules RULES = new LeaseRules(
            Duration.ofSeconds(3),
            Duration.ofSeconds(1),
            Duration.ofSeconds(60),
            LeaseRules.OnLoss.RETURN,
            Duration.ofSeconds(1));

    private static final Capabilities MODES = new Capabilities(
            Set.of(Capability.values()),
            List.of("GUIDED", "LOITER", "AUTO"),
            Map.of("GUIDED", Steering.ORDERS, "LOITER", Steering.STICKS));

    private final SteppedTime time = new SteppedTime(BEGAN);
    private final Lanes lanes = new Lanes(time, 2);
    private final Journal journal = new Journal(time);
    private final Fixtures.HeapDroneStore drones = new Fixtures.HeapDroneStore();
    private final Fixtures.HeapCommandStore commands = new Fixtures.HeapCommandStore();
    private final Fixtures.HeapLeaseStore leases = new Fixtures.HeapLeaseStore();
    private final Fixtures.RecordingChannel vehicle = new Fixtures.RecordingChannel();
    private final List<ControlChange.Kind> changes = new CopyOnWriteArrayList<>();
    private final CloudManager cloud = cloud();
    private final CommandGate gate = cloud.gate();
    private DroneLink link;

    private static CommandGate.Source operator(String name) {
        return new CommandGate.Source(new Principal(name, Role.OPERATOR), "rest");
    }

    private CloudManager cloud() {
        return cloud(new Watchdog(Duration.ofMinutes(5), Duration.ofMinutes(5), Duration.ofMinutes(10)));
    }

    private CloudManager cloud(Watchdog watchdog) {
        return new CloudManager(
                lanes,
                new CloudManager.Rules(watchdog, RULES),
                time,
                new CloudManager.Keeping(drones, commands, leases, journal),
                () -> new DroneId("drone-1"));
    }

    @BeforeEach
    void fly() {
        cloud.addListener(new CloudListener() {
            @Override
            public void controlChanged(DroneId drone, Control now, ControlChange change) {
                changes.add(change.kind());
            }
        });
        link = bound(cloud);
        hoverInGuided();
    }

    private DroneLink bound(CloudManager to) {
        LinkSession session =
                new LinkSession(new DroneKey("127.0.0.1", 14601, 1), "udp", false, "ArduCopter 1", vehicle);
        return Fixtures.bound(to.admit(new Claim(session, Fixtures.copter(null), null, true, 0)));
    }

    private void hoverInGuided() {
        hear(new DroneEvent.Identified(Fixtures.copter(null), MODES));
        hear(new DroneEvent.ModeHeard("GUIDED", true));
        hear(new DroneEvent.PhaseHeard(FlightPhase.IN_AIR));
    }

    @AfterEach
    void close() {
        lanes.close();
        journal.close();
    }

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
        Fence fence = vehicle.fences.get(report(old));
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
        apply(new LeaseEvent.Take("ann"));
        for (Command safe : List.of(new Command.Hold(), new Command.Land(), new Command.ReturnToLaunch())) {
            CommandRecord given =
                    gate.submit(SUE, link.id(), id("safe-" + safe.summary().replace(' ', '-')), safe);
            assertThat(vehicle.fences.get(report(given)).isOpen()).isTrue();
            apply(new LeaseEvent.Take("ann"));
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
        apply(new LeaseEvent.Take("ann"));

        assertThat(gate.submit(BOB, link.id(), id("read-0001"), new Command.ReadParameters())
                        .outcome())
                .isNull();
        assertThat(control().isHeldBy("ann")).isTrue();
    }

    @Test
    void holdsAndThenCallsBackADroneWhoseHolderIsLost() {
        apply(new LeaseEvent.Take("ann"));

        until(() -> vehicle.performed.contains(new Command.Hold()));
        until(() -> vehicle.performed.contains(new Command.ReturnToLaunch()));

        assertThat(vehicle.performed).containsExactly(new Command.Hold(), new Command.ReturnToLaunch());
        assertThat(commands.records.values()).allMatch(record -> record.by().equals("dronemap"));
    }

    @Test
    void remembersThatADroneHasToBeCalledBackUntilItIs() {
        apply(new LeaseEvent.Take("ann"));

        until(() -> leases.leases.values().stream().anyMatch(SavedLease::lapsed));
        until(() -> vehicle.performed.contains(new Command.ReturnToLaunch()));
        until(leases.leases::isEmpty);
    }

    @Test
    void callsADroneBackAfterARestartAsSoonAsItIsHeard() {
        until(() -> !drones.records.isEmpty());
        leases.save(new SavedLease(
                link.id(), "ann", time.clock().instant(), control().epoch(), true));

        CloudManager again = cloud();
        Steps.throughout(time, Duration.ofSeconds(2), vehicle.performed::isEmpty);
        link = bound(again);
        hoverInGuided();

        until(() -> vehicle.performed.contains(new Command.ReturnToLaunch()));
        until(leases.leases::isEmpty);
    }

    @Test
    void callsNothingBackThatFellSilentBeforeAndIsHeardLater() {
        Duration soon = Duration.ofSeconds(1);
        CloudManager hasty = cloud(new Watchdog(soon, soon, soon));
        List<ControlChange.Kind> seen = new CopyOnWriteArrayList<>();
        hasty.addListener(new CloudListener() {
            @Override
            public void controlChanged(DroneId drone, Control now, ControlChange change) {
                seen.add(change.kind());
            }
        });
        link = bound(hasty);
        hoverInGuided();
        hasty.controls().apply(link.id(), new LeaseEvent.Take("ann"));

        until(() -> seen.contains(ControlChange.Kind.RETURN_DUE));
        hear(new DroneEvent.ModeHeard("LOITER", true));
        Steps.throughout(time, Duration.ofSeconds(1), () -> !vehicle.performed.contains(new Command.ReturnToLaunch()));
    }

    @Test
    void leavesADroneAloneThatFliesItsMissionWithoutItsHolder() {
        hear(new DroneEvent.ModeHeard("AUTO", true));
        apply(new LeaseEvent.Take("ann"));

        until(() -> changes.contains(ControlChange.Kind.RETURN_DUE));

        hear(new DroneEvent.ModeHeard("AUTO", true));
        assertThat(vehicle.performed).isEmpty();
    }

    @Test
    void doesNotCallBackWhatSomebodyElseHasTaken() {
        apply(new LeaseEvent.Take("ann"));
        until(() -> vehicle.performed.contains(new Command.Hold()));
        apply(new LeaseEvent.Take("bob"));
        Steps.throughout(time, Duration.ofSeconds(2), () -> {
            apply(new LeaseEvent.Heartbeat("bob", control().epoch()));
            return !vehicle.performed.contains(new Command.ReturnToLaunch());
        });
    }

    @Test
    void givesWayToThePilotAtTheVehicle() {
        apply(new LeaseEvent.Take("ann"));
        awaitTick();
        hear(new DroneEvent.ModeHeard("LOITER", true));

        until(() -> control().tenure().holder() instanceof Holder.Pilot);
        assertThat(gate.submit(ANN, link.id(), id("first-001"), new Command.SetMode("GUIDED"))
                        .outcome())
                .isInstanceOf(Outcome.Refused.class);

        apply(new LeaseEvent.Take("ann"));
        assertThat(gate.submit(ANN, link.id(), id("first-002"), new Command.SetMode("GUIDED"))
                        .outcome())
                .isNull();
    }

    @Test
    void takesNeitherItsOwnCommandsNorAFailSafeForAPilot() {
        CommandRecord asked = gate.submit(ANN, link.id(), id("first-001"), new Command.SetMode("LOITER"));
        report(asked);
        awaitTick();
        hear(new DroneEvent.ModeHeard("LOITER", true));
        awaitTick();
        report(asked).ended(new Outcome.Succeeded());
        hear(new DroneEvent.ModeHeard("GUIDED", true));
        awaitTick();
        hear(new DroneEvent.TextHeard(Severity.WARNING, "EKF Failsafe: changed to LOITER"));
        hear(new DroneEvent.ModeHeard("LOITER", true));
        awaitTick();

        assertThat(changes).doesNotContain(ControlChange.Kind.PILOT_ACTED);
    }

    @Test
    void rebuildsExplicitControlAfterARestartWithANewerEpoch() {
        apply(new LeaseEvent.Take("ann"));
        long before = control().epoch();
        until(() -> !drones.records.isEmpty());

        CloudManager again = cloud();

        assertThat(again.controls().control(link.id()).isHeldBy("ann")).isTrue();
        assertThat(again.controls().control(link.id()).epoch()).isGreaterThan(before);
    }

    @Test
    void refusesAClientThatBelievesInControlThatHasEnded() {
        apply(new LeaseEvent.Take("ann"));
        long old = control().epoch();
        apply(new LeaseEvent.Take("ann"));

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

    private Control control() {
        return cloud.controls().control(link.id());
    }

    private void apply(LeaseEvent event) {
        assertThat(cloud.controls().apply(link.id(), event).answer()).isInstanceOf(LeaseAnswer.Granted.class);
    }

    private void hear(DroneEvent event) {
        link.lane().execute(() -> link.accept(event));
        time.settle();
    }

    private void until(BooleanSupplier holds) {
        Steps.until(time, holds);
    }

    /** Until the lane has looked at the drone once more. */
    private void awaitTick() {
        AtomicBoolean ticked = new AtomicBoolean();
        Lane.Ticker ticker = () -> ticked.set(true);
        link.lane().execute(() -> link.lane().addTicker(ticker));
        until(ticked::get);
        link.lane().execute(() -> link.lane().removeTicker(ticker));
    }

    private VehicleChannel.Report report(CommandRecord command) {
        until(() -> vehicle.reports.containsKey(command.id()));
        return vehicle.reports.get(command.id());
    }

    private static CommandId id(String value) {
        return new CommandId(value);
    }
}
