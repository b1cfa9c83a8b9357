package org.dronemap.ws.lab;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.dronemap.core.access.AccessKey;
import org.dronemap.core.access.AccountState;
import org.dronemap.core.access.EffectivePermissions;
import org.dronemap.core.access.KeyScope;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.User;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.core.process.ProcessStart;
import org.dronemap.core.time.SteppedTime;
import org.dronemap.mavlink.Frame;
import org.dronemap.sim.physics.LocalFrame;
import org.dronemap.sim.physics.NeuPosition;
import org.dronemap.store.memory.MemoryStores;
import org.dronemap.ws.wiring.SteppedServer;
import org.jspecify.annotations.Nullable;

/**
 * A whole server, as it is wired in earnest but without faces and sockets, and simulated vehicles on wires of memory: all in
 * the thread of the test and in stepped time. The same seed is the same flight, on every machine. Nobody waits: two minutes
 * in the air take a fraction of a second.
 */
public final class Laboratory implements AutoCloseable {
    private static final Instant BEGAN = Instant.parse("2026-05-01T10:00:00Z");
    private static final double SPACING_METERS = 60;
    private static final int FIRST_PEER = 200;
    private static final int FIRST_ROBOT = 3_301;
    private static final int FIRST_PORT_OF_PEERS = 40_000;
    private static final int FIRST_PEER_PORT = 40_500;
    private static final Duration BEAT = Duration.ofMillis(20);
    private static final Duration LOOK = Duration.ofMillis(100);
    private static final Duration LONGEST_PREPARATION = Duration.ofSeconds(60);

    private final SteppedTime time;
    private final long seed;
    private final boolean separates;
    private final DataFolder data = new DataFolder();
    private final MemoryStores stores = new MemoryStores();
    private final FlightFingerprint record;
    private final List<LabDrone> drones = new ArrayList<>();
    private final List<LabPeerLink> lines = new ArrayList<>();
    private final List<ScriptedPeer> peers = new ArrayList<>();
    private final List<SigningPeer> signingPeers = new ArrayList<>();
    private final List<HoveringVehicle> hoverers = new ArrayList<>();
    private final List<MemoryLinkRobot> robots = new ArrayList<>();
    private SteppedTime.@Nullable Killable process;
    private @Nullable SteppedServer server;

    public Laboratory(long seed) {
        this(seed, LaboratorySetup.isSeparationOn());
    }

    Laboratory(long seed, boolean separates) {
        this.seed = seed;
        this.separates = separates;
        time = new SteppedTime(BEGAN, seed);
        record = new FlightFingerprint(time::nanos);
        var unused = time.worker("vehicles", 1).every(BEAT, BEAT, () -> drones.forEach(LabDrone::beat));
        startServer();
    }

    /** Over what an earlier one has kept. */
    public void startServer() {
        startServer(ProcessStart.ORDINARY);
    }

    public void startServer(ProcessStart beginning) {
        process = time.killable();
        server = new SteppedServer(data.path(), separates ? process : SeparationOff.in(process), stores, beginning);
        drones.forEach(drone -> drone.attach(server().links()));
        peers.forEach(peer -> peer.wire().attach(server().links()));
        signingPeers.forEach(peer -> peer.wire().attach(server().links()));
        hoverers.forEach(peer -> peer.wire().attach(server().links()));
        robots.forEach(robot -> robot.attach(server().robots()));
        lines.forEach(line -> line.attach(server));
    }

    /** As by SIGSTOP: nothing is done for so long, while time and vehicles go on. */
    public void stopServer(Duration howLong) {
        SteppedTime.Killable standing = Objects.requireNonNull(process);
        standing.stop();
        goOn(howLong);
        standing.goOn();
    }

    /** As by kill -9: nothing more is done, written or said. */
    public void crashServer() {
        if (process != null) {
            process.kill();
        }
        drones.forEach(drone -> drone.attach(null));
        peers.forEach(peer -> peer.wire().attach(null));
        signingPeers.forEach(peer -> peer.wire().attach(null));
        hoverers.forEach(peer -> peer.wire().attach(null));
        robots.forEach(robot -> robot.attach(null));
        lines.forEach(line -> line.attach(null));
        server = null;
    }

    public boolean isUp() {
        return server != null;
    }

    /** In the place of a server that has crashed, until there is one again. */
    public SecondGroundStation otherStation(LabDrone drone, List<Geodetic> places, double meters) {
        SecondGroundStation station = new SecondGroundStation(places, meters);
        drone.attach(station);
        return station;
    }

    public SteppedServer server() {
        return Optional.ofNullable(server).orElseThrow(() -> new IllegalStateException("the server has crashed"));
    }

    public MemoryStores stores() {
        return stores;
    }

    public SteppedTime time() {
        return time;
    }

    public Instant now() {
        return time.clock().instant();
    }

    /** A copter on the ground, ready to arm, sixty metres from the one before. */
    public LabDrone copter() {
        return ready(add(VehicleSpec.COPTER));
    }

    /** So many of them, in a row. */
    public List<LabDrone> copters(int count) {
        List<LabDrone> made = IntStream.range(0, count)
                .mapToObj(number -> add(VehicleSpec.COPTER))
                .toList();
        made.forEach(this::ready);
        return made;
    }

    /** Such a vehicle, of which nothing is expected yet. */
    public LabDrone add(VehicleSpec kit) {
        return add(kit, LabDrone.FIELD.shifted(new NeuPosition(0, drones.size() * SPACING_METERS, 0)));
    }

    /** The same with the place where it is put down. */
    public LabDrone add(VehicleSpec kit, LocalFrame start) {
        return add(kit, start, drones.size() + 1);
    }

    /** The same, by the name of that system id, which others may have, too. */
    public LabDrone add(VehicleSpec kit, int systemId) {
        return add(kit, LabDrone.FIELD.shifted(new NeuPosition(0, drones.size() * SPACING_METERS, 0)), systemId);
    }

    private LabDrone add(VehicleSpec kit, LocalFrame start, int systemId) {
        int number = drones.size() + 1;
        LabDrone drone = new LabDrone(
                this, kit, start, new LabDrone.Numbers(number, systemId, seed * 1_000_003 + number), record);
        drones.add(drone);
        drone.attach(server().links());
        return drone;
    }

    /** Several vehicles have that system id. */
    boolean hasTwins(int systemId) {
        return drones.stream().filter(drone -> drone.systemId() == systemId).count() > 1;
    }

    /** Somebody of whom the test says what they answer. */
    public ScriptedPeer peer(int systemId, ScriptedPeer.Kind kind, ScriptedPeer.Answers answers) {
        ScriptedPeer peer = new ScriptedPeer(this, FIRST_PORT_OF_PEERS + peers.size(), systemId, kind, answers);
        peers.add(peer);
        peer.wire().attach(server().links());
        return peer;
    }

    LabVehicleLink wire(String name, int port, Consumer<Frame> vehicle) {
        return new LabVehicleLink(name, port, time, seed * 1_000_003 + port, record, vehicle);
    }

    /** What the test speaks for, over such a wire; it says nothing before {@link SigningPeer#begin}. */
    public SigningPeer signingPeer(int systemId, LabVehicleLink.Kind kind) {
        int number = signingPeers.size() + 1;
        long chance = seed * 1_000_003 + FIRST_PEER_PORT + number;
        SigningPeer peer = new SigningPeer(
                this,
                systemId,
                hear -> new LabVehicleLink("peer " + number, FIRST_PEER_PORT + number, time, chance, record, hear));
        peer.wire().is(kind);
        peer.wire().attach(server().links());
        signingPeers.add(peer);
        return peer;
    }

    /** The same over datagrams of this machine. */
    public SigningPeer signingPeer(int systemId) {
        return signingPeer(systemId, LabVehicleLink.Kind.UDP);
    }

    /** Waits until the server knows it with its home, and it says that it may be armed. */
    public LabDrone ready(LabDrone drone) {
        until(drone.name() + " is ready", LONGEST_PREPARATION, drone::isReady);
        return drone;
    }

    /** A vehicle that does what its script says, and nothing else. */
    public HoveringVehicle hoverer(HoveringVehicle.Script script) {
        int number = FIRST_PEER + hoverers.size();
        HoveringVehicle peer = new HoveringVehicle(this, number, seed * 1_000_003 + number, record, script);
        hoverers.add(peer);
        peer.wire().attach(server().links());
        return peer;
    }

    /** A robot on wheels that goes on with the last speeds that it heard, as many bridges do. */
    public MemoryLinkRobot robot() {
        int number = FIRST_ROBOT + robots.size();
        MemoryLinkRobot robot = new MemoryLinkRobot(this, number, seed * 1_000_003 + number);
        robots.add(robot);
        robot.attach(server().robots());
        return robot;
    }

    /** A phone so many metres north and east of where that drone was put down. */
    public SimulatedPhone phone(Pilot owner, LabDrone beside, double north, double east) {
        return new SimulatedPhone(this, owner, beside, north, east);
    }

    /** A new user with that role, who owns what is there. */
    public Pilot pilot(String name, Role role) {
        if (!stores.access().addUser(new User(name, role, AccountState.ACTIVE, "none", false, OrganisationId.HOME))) {
            throw new IllegalArgumentException("There is a user " + name + " already.");
        }
        return new Pilot(this, name, role, null);
    }

    /** Who says what users may do. */
    public Administrator administrator() {
        return new Administrator(this);
    }

    /** A ground station of that user's, by UDP. */
    public GroundStation station(Pilot user, int systemId) {
        return station(LabPeerLink.Kind.UDP, user.passphrase(), systemId);
    }

    /** One that signs with that passphrase; null: with none. */
    public GroundStation station(LabPeerLink.Kind kind, @Nullable String passphrase, int systemId) {
        return new GroundStation(this, lines.size() + 1, kind, passphrase, systemId);
    }

    /** A robot that calls in. */
    public LabRobot robot(RobotSpec kit) {
        return new LabRobot(this, kit, lines.size() + 1);
    }

    void add(LabPeerLink line) {
        lines.add(line);
        line.attach(server);
    }

    FlightFingerprint record() {
        return record;
    }

    long seed() {
        return seed;
    }

    /** Its server keeps drones of all operations apart. */
    public boolean separates() {
        return separates;
    }

    Principal principal(String name, Role role) {
        return principal(name, role, KeyScope.ALL, null);
    }

    /** By an access key, as the door of each face would let it in. */
    Principal principal(String name, String key) {
        AccessKey shown = stores.access().accessKeys(name).stream()
                .filter(one -> one.id().equals(key) && !one.rights().isOver(now()))
                .findFirst()
                .orElseThrow(() -> new AssertionError(name + " has no such key"));
        return principal(name, shown.rights().role(), shown.rights().scope(), key);
    }

    private Principal principal(String name, Role role, KeyScope scope, @Nullable String key) {
        EffectivePermissions reach = server().house().grantBook().permissionsOf(OrganisationId.HOME, name);
        return Principal.of(stores.access().user(name).orElseThrow(), role, scope, key, reach);
    }

    /** Lets so much time go by. */
    public void goOn(Duration much) {
        time.advance(much);
        requireSound();
    }

    /** Lets time go by until this holds; the test fails when it takes longer than that. */
    public void until(String what, Duration longest, BooleanSupplier holds) {
        boolean held = time.advanceUntil(holds, longest);
        requireSound();
        if (!held) {
            throw new AssertionError("Not within " + longest.toSeconds() + " s: " + what + "\n" + picture());
        }
    }

    /** The same for what takes long to look at: ten times a second. */
    public void untilSeen(String what, Duration longest, BooleanSupplier holds) {
        long[] next = {time.nanos()};
        until(what, longest, () -> {
            if (time.nanos() < next[0]) {
                return false;
            }
            next[0] = time.nanos() + LOOK.toNanos();
            return holds.getAsBoolean();
        });
    }

    /** The same for what appears. */
    public <T> T until(String what, Duration longest, Supplier<Optional<T>> appears) {
        List<T> found = new ArrayList<>(1);
        until(what, longest, holds(appears, found));
        return found.get(0);
    }

    /** The same for what appears and takes long to look at. */
    public <T> T untilSeen(String what, Duration longest, Supplier<Optional<T>> appears) {
        List<T> found = new ArrayList<>(1);
        untilSeen(what, longest, holds(appears, found));
        return found.get(0);
    }

    private static <T> BooleanSupplier holds(Supplier<Optional<T>> appears, List<T> found) {
        return () -> {
            appears.get().ifPresent(found::add);
            return !found.isEmpty();
        };
    }

    /** Lets time go by, and holds this all along. */
    public void throughout(String what, Duration time, BooleanSupplier holds) {
        if (this.time.advanceUntil(() -> !holds.getAsBoolean(), time)) {
            throw new AssertionError("No longer: " + what + "\n" + picture());
        }
        requireSound();
    }

    private void requireSound() {
        if (!time.failures().isEmpty()) {
            throw new AssertionError(
                    "Something failed in the server or a vehicle",
                    time.failures().get(0));
        }
    }

    String picture() {
        StringBuilder text = new StringBuilder("at " + now());
        drones.forEach(drone -> text.append('\n').append(drone.words()));
        peers.forEach(peer -> text.append('\n').append(peer.words()));
        return text.toString();
    }

    /** SHA-256 of all frames, commands' outcomes and journals of this flight; the last that it can be asked. */
    public String sum() {
        record.note(stores, drones.stream().map(LabDrone::id).toList());
        return record.sum();
    }

    /** Frames in both directions so far. */
    public long frames() {
        return record.frames();
    }

    @Override
    public void close() {
        if (server != null) {
            server.close();
        }
        data.close();
    }
}
