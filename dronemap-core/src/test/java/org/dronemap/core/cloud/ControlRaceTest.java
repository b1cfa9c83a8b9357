package org.dronemap.core.cloud;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.lane.Lanes;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.cloud.lane.Watchdog;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.time.RealTime;
import org.junit.jupiter.api.Test;

/** Many threads want one drone, and take it from each other while commands are on their way. */
class ControlRaceTest {
    private static final int RACERS = 8;
    private static final int ROUNDS = 600;

    private final Lanes lanes = new Lanes(new RealTime(), 2);
    private final StoreWriter journal = new StoreWriter(new RealTime());
    private final AtomicInteger numbers = new AtomicInteger();
    private final CloudFixtures.InMemoryCommandStore store = new CloudFixtures.InMemoryCommandStore();
    private final Stubborn vehicle = new Stubborn();
    private final CloudManager cloud = new CloudManager(
            lanes,
            Watchdog.DEFAULT,
            new RealTime(),
            new CloudManager.Persistence(
                    new CloudFixtures.InMemoryDroneStore(),
                    store,
                    new CloudFixtures.InMemoryLeaseStore(),
                    new CloudFixtures.InMemoryParameterOverrideStore(),
                    journal),
            () -> new DroneId("drone-1"));

    /** What was seen on the wire: whose command, of which epoch. */
    private record Sent(String by, long epoch) {}

    @Test
    void neverSendsACommandOfAnOldEpochNorOfTwoHoldersInOne() throws Exception {
        DroneLink link = connect();
        ExecutorService racers = Executors.newFixedThreadPool(RACERS);
        try {
            List<Future<?>> all = new ArrayList<>();
            for (int racer = 0; racer < RACERS; racer++) {
                String name = "racer-" + racer;
                Random random = new Random(racer);
                all.add(racers.submit(() -> race(link, name, random)));
            }
            for (Future<?> each : all) {
                each.get(120, TimeUnit.SECONDS);
            }
        } finally {
            racers.shutdownNow();
            lanes.close();
            journal.close();
        }
        judge(vehicle.wire());
    }

    private void judge(List<Sent> wire) {
        assertThat(wire).hasSizeGreaterThan(RACERS);
        ConcurrentHashMap<Long, String> holders = new ConcurrentHashMap<>();
        long newest = 0;
        for (Sent sent : wire) {
            assertThat(sent.epoch()).isGreaterThanOrEqualTo(newest);
            newest = sent.epoch();
            assertThat(holders.computeIfAbsent(sent.epoch(), epoch -> sent.by()))
                    .isEqualTo(sent.by());
        }
        assertThat(holders.values().stream().distinct()).hasSizeGreaterThan(1);
    }

    private void race(DroneLink link, String name, Random random) {
        CommandGate.Source source = new CommandGate.Source(new Principal(name, Role.SUPERVISOR), "rest");
        for (int round = 0; round < ROUNDS; round++) {
            switch (random.nextInt(12)) {
                case 0 -> cloud.controls().apply(link.id(), new LeaseEvent.TakeOver(name, "a race"));
                case 1 -> cloud.controls().apply(link.id(), new LeaseEvent.Release(name));
                default -> {
                    CommandId id = new CommandId("race-command-" + numbers.incrementAndGet());
                    Command go = new Command.GoTo(new Geodetic(47 + round / 1000.0, 8), Altitude.aboveHome(20));
                    CommandRecord given = cloud.gate().submit(source, link.id(), id, go);
                    assertThat(given.by()).isEqualTo(name);
                }
            }
            LockSupport.parkNanos(random.nextInt(300_000));
        }
    }

    private DroneLink connect() {
        LinkSession session =
                new LinkSession(new DroneKey("127.0.0.1", 14601, 1), "udp", false, "ArduCopter 1", vehicle);
        DroneLink link =
                CloudFixtures.bound(cloud.admit(new Claim(session, CloudFixtures.copter(null), null, true, 0)));
        CompletableFuture<Void> done = new CompletableFuture<>();
        link.lane().execute(() -> {
            link.accept(new DroneEvent.Identified(CloudFixtures.copter(null), CloudFixtures.ALL));
            link.accept(new DroneEvent.ModeReported("GUIDED", true));
            link.accept(new DroneEvent.PhaseReported(FlightPhase.IN_AIR));
            link.lane().addTimedTask(() -> {
                vehicle.tick();
                link.received();
            });
            done.complete(null);
        });
        assertThat(done).succeedsWithin(30, TimeUnit.SECONDS);
        return link;
    }

    /**
     * Repeats every command at every tick, whether or not it was told to stop: only the fence is between. Some are sent for
     * the first time long after they were decided.
     */
    private final class Stubborn implements VehicleChannel {
        private final Random delays = new Random(99);
        private final List<Sent> wire = new ArrayList<>();
        private final List<Runnable> repeated = new ArrayList<>();

        @Override
        public void steer(SendAuthority mandate, Setpoint setpoint) {
            throw new AssertionError("nobody steers here");
        }

        @Override
        public void perform(SendAuthority mandate, Command command, Report report) {
            CommandRecord record = store.records.get(mandate.command());
            Sent sent = new Sent(record.by(), record.epoch() == null ? -1 : record.epoch());
            Runnable send = () -> mandate.fence().pass(() -> {
                synchronized (wire) {
                    wire.add(sent);
                }
            });
            switch (delays.nextInt(3)) {
                case 0 -> send.run();
                case 1 -> {
                    LockSupport.parkNanos(delays.nextInt(1_000_000));
                    send.run();
                }
                default -> LockSupport.parkNanos(1); // at the next tick
            }
            if (repeated.size() == 30) {
                repeated.remove(0);
            }
            repeated.add(send);
            report.ended(new Outcome.Succeeded());
        }

        void tick() {
            repeated.forEach(Runnable::run);
        }

        List<Sent> wire() {
            synchronized (wire) {
                return List.copyOf(wire);
            }
        }

        @Override
        public void cancel(CommandId id) {
            // stubborn
        }

        @Override
        public void probe() {
            // is heard at every tick
        }
    }
}
