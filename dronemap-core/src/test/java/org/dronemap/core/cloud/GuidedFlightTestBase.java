package org.dronemap.core.cloud;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.lane.Lane;
import org.dronemap.core.cloud.lane.Lanes;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.cloud.lane.Watchdog;
import org.dronemap.core.cloud.listener.CloudListener;
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
import org.dronemap.core.drone.Position;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.lease.ControlState;
import org.dronemap.core.lease.LeaseAnswer;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.lease.LeaseRules;
import org.dronemap.core.time.SteppedTime;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;

/** A copter in guided flight, in stepped time, and all that is commanded of it. */
abstract class GuidedFlightTestBase {
    static final CommandGate.Source ANN = operator("ann");
    static final CommandGate.Source BOB = operator("bob");
    static final CommandGate.Source SUE = new CommandGate.Source(new Principal("sue", Role.SUPERVISOR), "rest");
    static final Instant BEGAN = Instant.parse("2026-03-04T05:06:07Z");
    static final Geodetic HERE = new Geodetic(24.7136, 46.6753);
    static final Duration PATIENCE = Duration.ofSeconds(30);
    /** As quick as it may be. */
    static final LeaseRules RULES = new LeaseRules(
            Duration.ofSeconds(3),
            Duration.ofSeconds(1),
            Duration.ofSeconds(60),
            LeaseRules.OnLoss.RETURN,
            Duration.ofSeconds(1));

    static final Capabilities MODES = new Capabilities(
            Set.of(Capability.values()),
            List.of("GUIDED", "LOITER", "AUTO"),
            Map.of("GUIDED", Steering.ORDERS, "LOITER", Steering.STICKS, "AUTO", Steering.MISSION));

    final SteppedTime time = new SteppedTime(BEGAN);
    /** The same, whose process may have stood still meanwhile. */
    final StallingTime stalling = new StallingTime(time);

    private final AtomicInteger numbers = new AtomicInteger();
    final Lanes lanes = new Lanes(stalling.time(), 2);
    final StoreWriter journal = new StoreWriter(time);
    final CloudFixtures.InMemoryDroneStore drones = new CloudFixtures.InMemoryDroneStore();
    final CloudFixtures.InMemoryCommandStore commands = new CloudFixtures.InMemoryCommandStore();
    final CloudFixtures.InMemoryLeaseStore leases = new CloudFixtures.InMemoryLeaseStore();
    final CloudFixtures.InMemoryParameterOverrideStore owners = new CloudFixtures.InMemoryParameterOverrideStore();
    final CloudFixtures.RecordingChannel vehicle = new CloudFixtures.RecordingChannel();
    final List<ControlChange.Kind> changes = new CopyOnWriteArrayList<>();
    final CloudManager cloud = cloud();
    final CommandGate gate = cloud.gate();
    DroneLink link;

    static CommandGate.Source operator(String name) {
        return new CommandGate.Source(new Principal(name, Role.OPERATOR), "rest");
    }

    CloudManager cloud() {
        return cloud(new Watchdog(Duration.ofMinutes(5), Duration.ofMinutes(5), Duration.ofMinutes(10)));
    }

    CloudManager cloud(Watchdog watchdog) {
        return new CloudManager(
                lanes,
                new CloudManager.Rules(watchdog, RULES, 20),
                stalling.time(),
                new CloudManager.Persistence(drones, commands, leases, owners, journal),
                () -> new DroneId("drone-" + numbers.incrementAndGet()));
    }

    @BeforeEach
    void fly() {
        cloud.addListener(new CloudListener() {
            @Override
            public void controlChanged(DroneId drone, ControlState now, ControlChange change) {
                changes.add(change.kind());
            }
        });
        link = bound(cloud);
        hoverInGuided();
    }

    DroneLink bound(CloudManager to) {
        LinkSession session =
                new LinkSession(new DroneKey("127.0.0.1", 14601, 1), "udp", false, "ArduCopter 1", vehicle);
        return CloudFixtures.bound(to.admit(new Claim(session, CloudFixtures.copter(null), null, true, 0)));
    }

    void hoverInGuided() {
        hear(new DroneEvent.Identified(CloudFixtures.copter(null), MODES));
        hear(new DroneEvent.ModeReported("GUIDED", true));
        hear(new DroneEvent.PhaseReported(FlightPhase.IN_AIR));
        hear(new DroneEvent.PositionReported(new Position(HERE, null, 20.0)));
    }

    /** From here on this cloud was the last that commanded it; by a command that moves nothing. */
    void isCommandedBy(CommandGate.Source source) {
        CommandId number = id("first-" + commands.records.size() + "-000");
        CommandRecord first = gate.submit(source, link.id(), number, new Command.TakePicture());
        report(first).ended(new Outcome.Succeeded());
        until(() -> commands.records.get(number).outcome() != null);
        vehicle.performed.clear();
        commands.records.remove(number);
    }

    void isDown() {
        hear(new DroneEvent.ModeReported("GUIDED", false));
    }

    @AfterEach
    void close() {
        lanes.close();
        journal.close();
    }

    ControlState control() {
        return cloud.controls().control(link.id());
    }

    void apply(LeaseEvent event) {
        assertThat(cloud.controls().apply(link.id(), event).answer()).isInstanceOf(LeaseAnswer.Granted.class);
    }

    void hear(DroneEvent event) {
        link.lane().execute(() -> link.accept(event));
        time.settle();
    }

    void until(BooleanSupplier holds) {
        SteppedUntil.until(time, holds);
    }

    /** Until the lane has looked at the drone once more. */
    void awaitTick() {
        AtomicBoolean ticked = new AtomicBoolean();
        Lane.TimedTask ticker = () -> ticked.set(true);
        link.lane().execute(() -> link.lane().addTimedTask(ticker));
        until(ticked::get);
        link.lane().execute(() -> link.lane().removeTimedTask(ticker));
    }

    VehicleChannel.Report report(CommandRecord command) {
        until(() -> vehicle.reports.containsKey(command.id()));
        return vehicle.reports.get(command.id());
    }

    static CommandId id(String value) {
        return new CommandId(value);
    }
}
