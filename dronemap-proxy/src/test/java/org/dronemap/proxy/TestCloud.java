package org.dronemap.proxy;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.CommandGate;
import org.dronemap.core.cloud.lane.Lanes;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.cloud.lane.Watchdog;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.CommandStore;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneRecord;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.DroneStore;
import org.dronemap.core.drone.KnownMission;
import org.dronemap.core.drone.ParameterOverrideStore;
import org.dronemap.core.drone.ParameterOverrides;
import org.dronemap.core.lease.LeaseStore;
import org.dronemap.core.lease.SavedLease;
import org.dronemap.core.time.RealTime;
import org.dronemap.core.time.Time;
import org.dronemap.proxy.endpoint.DtlsKeys;
import org.dronemap.proxy.endpoint.EndpointCounters;
import org.dronemap.proxy.endpoint.EndpointSecurity;
import org.dronemap.proxy.endpoint.EndpointUrl;
import org.dronemap.proxy.endpoint.Peer;
import org.dronemap.proxy.endpoint.PeerCounters;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.dronemap.proxy.session.Enrolment;
import org.dronemap.proxy.session.FrameTap;

/** A whole cloud in memory behind a proxy: with one UDP and one TCP port in real time, or without sockets in stepped time. */
public final class TestCloud implements AutoCloseable {
    private static final CommandGate.Source PILOT =
            new CommandGate.Source(new Principal("pilot", Role.OPERATOR), "rest");
    private static final Time REAL = new RealTime();
    private static final Duration BETWEEN_LOOKS = Duration.ofMillis(10);
    private static final Duration LONGEST_COMMAND = Duration.ofSeconds(60);

    private final Time time;
    private final Lanes lanes;
    private final StoreWriter journal;
    private final Commands commands = new Commands();
    private final CloudManager cloud;
    private final MavlinkConnector proxy;

    public TestCloud(int udpPort) {
        this(udpPort, componentId -> FrameTap.NONE);
    }

    public TestCloud(int udpPort, FrameTap.Factory taps) {
        this(
                List.of(
                        EndpointUrl.parse("udpserver://127.0.0.1:" + udpPort),
                        EndpointUrl.parse("tcpserver://127.0.0.1:0")),
                taps,
                new RealTime());
    }

    /** Without sockets, in stepped time too. */
    public TestCloud(FrameTap.Factory taps, Time time) {
        this(List.of(), taps, time);
    }

    private TestCloud(List<EndpointUrl> urls, FrameTap.Factory taps, Time time) {
        this.time = time;
        lanes = new Lanes(time, 2);
        journal = new StoreWriter(time);
        cloud = new CloudManager(
                lanes,
                Watchdog.DEFAULT,
                time,
                new CloudManager.Persistence(new Drones(), commands, new Leases(), new Owners(), journal),
                () -> new DroneId(UUID.randomUUID().toString()));
        proxy = new MavlinkConnector(
                cloud,
                lanes,
                urls,
                new MavlinkConnector.Policy(
                        TestKeyrings.of(cloud, journal),
                        taps,
                        EndpointSecurity.of(DtlsKeys.none()),
                        Enrolment.LOOPBACK),
                time);
        try {
            proxy.start();
        } catch (IOException e) {
            close();
            throw new IllegalStateException(e);
        }
    }

    public MavlinkConnector proxy() {
        return proxy;
    }

    public Lanes lanes() {
        return lanes;
    }

    /** A way in for the bytes of a peer that is no socket. */
    public PeerHandler opened(Peer peer) {
        return proxy.handlers().opened(peer, new PeerCounters(new EndpointCounters()));
    }

    /** The one that calls itself by that number, which has to be there. */
    public DroneState drone(int systemId) {
        return cloud.drones().stream()
                .filter(drone -> drone.link().key().systemId() == systemId)
                .findFirst()
                .orElseThrow();
    }

    public CloudManager cloud() {
        return cloud;
    }

    public int udpPort() {
        return proxy.endpoints().get(0).url().port();
    }

    public int tcpPort() {
        return proxy.endpoints().get(1).url().port();
    }

    /** The only drone, once it is there and looks as wanted. */
    public DroneState awaitDrone(Predicate<DroneState> wanted) {
        return await(
                time,
                Duration.ofSeconds(20),
                () -> cloud.drones().stream().filter(wanted).findFirst(),
                () -> "no drone as wanted among " + cloud.drones());
    }

    public static <T> T await(Duration patience, Supplier<Optional<T>> wanted, Supplier<String> otherwise) {
        return await(REAL, patience, wanted, otherwise);
    }

    /** By whatever time the thing goes that is waited for: stepped time is stepped meanwhile. */
    public static <T> T await(Time time, Duration patience, Supplier<Optional<T>> wanted, Supplier<String> otherwise) {
        long began = time.nanos();
        while (time.nanos() - began < patience.toNanos()) {
            Optional<T> found = wanted.get();
            if (found.isPresent()) {
                return found.get();
            }
            pause(time);
        }
        throw new AssertionError(otherwise.get());
    }

    public static void await(Duration patience, BooleanSupplier wanted, Supplier<String> otherwise) {
        await(REAL, patience, wanted, otherwise);
    }

    public static void await(Time time, Duration patience, BooleanSupplier wanted, Supplier<String> otherwise) {
        await(time, patience, () -> wanted.getAsBoolean() ? Optional.of(true) : Optional.empty(), otherwise);
    }

    private static void pause(Time time) {
        try {
            time.await(new CompletableFuture<Void>(), BETWEEN_LOOKS);
        } catch (TimeoutException e) {
            // So much time has gone by.
        } catch (ExecutionException e) {
            throw new AssertionError(e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new AssertionError(e);
        }
    }

    /** Gives a command and waits for its outcome. */
    public Outcome command(DroneId drone, Command command) {
        CommandId id = new CommandId(UUID.randomUUID().toString());
        cloud.gate().submit(PILOT, drone, id, command);
        try {
            Outcome outcome = time.await(cloud.gate().end(id), LONGEST_COMMAND).outcome();
            if (outcome == null) {
                throw new AssertionError("ended without an outcome");
            }
            return outcome;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new AssertionError(e);
        } catch (ExecutionException | TimeoutException e) {
            throw new AssertionError(command.summary(), e);
        }
    }

    /**
     * How often the cloud held the drone beyond once for each time that it was steered by sticks: while it is less than it was
     * before, a hold is still to come.
     */
    public long holdsBeyondSticks() {
        return count("Hold", "hold") - count("Steer", "steer by sticks");
    }

    private long count(String type, String summary) {
        return commands.records.values().stream()
                .filter(record -> record.type().equals(type)
                        && record.summary().equals(summary)
                        // Who was not let to the helm has no epoch, and leaves nothing to hold.
                        && (record.by().equals("dronemap") || (type.equals("Steer") && record.epoch() != null)))
                .count();
    }

    /** How many commands have no outcome yet. */
    public long commandsUnderWay() {
        return commands.records.values().stream()
                .filter(record -> record.outcome() == null)
                .count();
    }

    @Override
    public void close() {
        proxy.close();
        lanes.close();
        journal.close();
    }

    private static final class Drones implements DroneStore {
        private final ConcurrentHashMap<DroneId, DroneRecord> records = new ConcurrentHashMap<>();
        private final ConcurrentHashMap<DroneId, KnownMission> missions = new ConcurrentHashMap<>();

        @Override
        public List<DroneRecord> drones() {
            return List.copyOf(records.values());
        }

        @Override
        public void save(DroneRecord drone) {
            records.put(drone.id(), drone);
        }

        @Override
        public void delete(DroneId id) {
            records.remove(id);
        }

        @Override
        public Optional<KnownMission> knownMission(DroneId id) {
            return Optional.ofNullable(missions.get(id));
        }

        @Override
        public void saveKnownMission(DroneId id, KnownMission mission) {
            missions.put(id, mission);
        }
    }

    private static final class Commands implements CommandStore {
        private final ConcurrentHashMap<CommandId, CommandRecord> records = new ConcurrentHashMap<>();

        @Override
        public boolean begin(CommandRecord command) {
            return records.putIfAbsent(command.id(), command) == null;
        }

        @Override
        public void finish(CommandRecord command) {
            records.put(command.id(), command);
        }

        @Override
        public Optional<CommandRecord> command(CommandId id) {
            return Optional.ofNullable(records.get(id));
        }

        @Override
        public List<CommandRecord> commandsOf(DroneId drone, int limit) {
            return records.values().stream()
                    .filter(record -> record.drone().equals(drone))
                    .limit(limit)
                    .toList();
        }

        @Override
        public int endUnfinished(Outcome outcome, Instant at) {
            return 0;
        }
    }

    private static final class Owners implements ParameterOverrideStore {
        private final ConcurrentHashMap<DroneId, ParameterOverrides> kept = new ConcurrentHashMap<>();

        @Override
        public List<ParameterOverrides> all() {
            return List.copyOf(kept.values());
        }

        @Override
        public void save(ParameterOverrides values) {
            kept.put(values.drone(), values);
        }

        @Override
        public void delete(DroneId drone) {
            kept.remove(drone);
        }
    }

    /** No lease outlives a test. */
    private static final class Leases implements LeaseStore {
        private final AtomicLong reserved = new AtomicLong();

        @Override
        public List<SavedLease> leases() {
            return List.of();
        }

        @Override
        public void save(SavedLease lease) {}

        @Override
        public void delete(DroneId drone) {}

        @Override
        public long reserve(int count) {
            return reserved.addAndGet(count);
        }
    }
}
