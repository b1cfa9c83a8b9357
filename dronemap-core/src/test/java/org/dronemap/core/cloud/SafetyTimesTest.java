package org.dronemap.core.cloud;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.lane.Lanes;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.cloud.lane.Watchdog;
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
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.lease.LeaseRules;
import org.dronemap.core.time.RealTime;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Each time that flying safely hangs on is one of the real clock: everywhere else these are looked at in stepped time. */
class SafetyTimesTest {
    private static final Duration SILENCE = Duration.ofSeconds(3);
    private static final Duration SHORT = Duration.ofSeconds(1);
    /** A machine with much to do may be late by as much, and still not by a factor that units confused are. */
    private static final Duration LATE = Duration.ofSeconds(10);

    private static final Capabilities MODES = new Capabilities(
            Set.of(Capability.values()),
            List.of("GUIDED", "LOITER", "AUTO"),
            Map.of("GUIDED", Steering.ORDERS, "LOITER", Steering.STICKS));

    private final RealTime time = new RealTime();
    private final Lanes lanes = new Lanes(time, 2);
    private final StoreWriter journal = new StoreWriter(time);
    private final CloudFixtures.RecordingChannel vehicle = new CloudFixtures.RecordingChannel();

    @AfterEach
    void close() {
        lanes.close();
        journal.close();
    }

    @Test
    void aDroneHoldsThreeSecondsAfterItsHolderFellSilentAndReturnsASecondLater() {
        CloudManager cloud = cloud(Watchdog.DEFAULT);
        DroneLink link = hovering(cloud);
        keepAlive(link);
        CommandRecord first = command(cloud, link);
        await().atMost(LATE).until(() -> vehicle.reports.containsKey(first.id()));
        vehicle.reports.get(first.id()).ended(new Outcome.Succeeded());
        vehicle.performed.clear();
        long since = time.nanos();
        cloud.controls().apply(link.id(), new LeaseEvent.TakeControl("ann"));

        takes(since, SILENCE, () -> vehicle.performed.contains(new Command.Hold()));
        takes(since, SILENCE.plus(SHORT), () -> vehicle.performed.contains(new Command.ReturnToLaunch()));

        assertThat(vehicle.performed).containsExactly(new Command.Hold(), new Command.ReturnToLaunch());
    }

    @Test
    void aDroneIsLostWhenItWasSilentForTheTimeOfTheWatchdog() {
        CloudManager cloud = cloud(new Watchdog(SHORT, SHORT, Duration.ofSeconds(2)));
        long since = time.nanos();
        DroneLink link = hovering(cloud);

        takes(
                since,
                Duration.ofSeconds(2),
                () -> cloud.drone(link.id()).orElseThrow().link().state() == LinkState.LOST);
    }

    @Test
    void controlThatCameWithACommandEndsASecondAfterIt() {
        CloudManager cloud = cloud(Watchdog.DEFAULT);
        DroneLink link = hovering(cloud);
        keepAlive(link);
        long since = time.nanos();
        CommandRecord given = command(cloud, link);
        await().atMost(LATE).until(() -> vehicle.reports.containsKey(given.id()));
        vehicle.reports.get(given.id()).ended(new Outcome.Succeeded());

        takes(since, SHORT, () -> cloud.controls().control(link.id()).tenure() == null);
    }

    private static CommandRecord command(CloudManager cloud, DroneLink link) {
        return cloud.gate()
                .submit(
                        new CommandGate.Source(new Principal("ann", Role.OPERATOR), "rest"),
                        link.id(),
                        new CommandId("first-001"),
                        new Command.SetMode("GUIDED"));
    }

    /** By the clock of the machine: not sooner, and not later than a busy machine is late. */
    private void takes(long since, Duration expected, Callable<Boolean> holds) {
        await().atMost(expected.plus(LATE)).pollInterval(Duration.ofMillis(10)).until(holds);
        assertThat(Duration.ofNanos(time.nanos() - since)).isGreaterThanOrEqualTo(expected);
    }

    private CloudManager cloud(Watchdog watchdog) {
        LeaseRules rules = new LeaseRules(SILENCE, SHORT, Duration.ofSeconds(60), LeaseRules.OnLoss.RETURN, SHORT);
        return new CloudManager(
                lanes,
                new CloudManager.Rules(watchdog, rules, 20),
                time,
                new CloudManager.Persistence(
                        new CloudFixtures.InMemoryDroneStore(),
                        new CloudFixtures.InMemoryCommandStore(),
                        new CloudFixtures.InMemoryLeaseStore(),
                        new CloudFixtures.InMemoryParameterOverrideStore(),
                        journal),
                () -> new DroneId("drone-1"));
    }

    private DroneLink hovering(CloudManager cloud) {
        LinkSession session =
                new LinkSession(new DroneKey("127.0.0.1", 14601, 1), "udp", false, "ArduCopter 1", vehicle);
        DroneLink link =
                CloudFixtures.bound(cloud.admit(new Claim(session, CloudFixtures.copter(null), null, true, 0)));
        onLane(link, () -> {
            link.accept(new DroneEvent.Identified(CloudFixtures.copter(null), MODES));
            link.accept(new DroneEvent.ModeReported("GUIDED", true));
            link.accept(new DroneEvent.PhaseReported(FlightPhase.IN_AIR));
            link.accept(new DroneEvent.PositionReported(new Position(new Geodetic(24.7, 46.7), null, 20.0)));
        });
        return link;
    }

    private static void keepAlive(DroneLink link) {
        onLane(link, () -> link.lane().addTimedTask(link::received));
    }

    private static void onLane(DroneLink link, Runnable work) {
        CompletableFuture<Void> done = new CompletableFuture<>();
        link.lane().execute(() -> {
            work.run();
            done.complete(null);
        });
        assertThat(done).succeedsWithin(LATE);
    }
}
