package org.dronemap.proxy.outlet;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.Journal;
import org.dronemap.core.cloud.Mandate;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.time.SystemTime;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.MessageTable;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.TestCloud;
import org.dronemap.proxy.endpoint.Doors;
import org.dronemap.proxy.endpoint.DtlsKeys;
import org.dronemap.proxy.session.FrameTap;

/** A cloud with one vehicle on a real socket, its outlet, and somebody at it; tells what gets through to that socket. */
final class MatrixHouse implements AutoCloseable {
    /** What fills messages that mean nothing in particular: the cloud says nothing of its own with it. */
    static final int FILL = 0x2A;

    private static final Duration PATIENCE = Duration.ofSeconds(20);
    private static final Heartbeat GROUND = new Heartbeat(6, 8, 0, 0, 4, 3);
    /** Frames that two threads send at a time may be noted in the other order; fewer than there are sequence numbers. */
    private static final int ASTRAY = 64;

    private static final int HOLD = 17;
    private static final long LOOK_NANOS = 100_000;
    private static final int SECOND_NANOS = 1_100_000_000;

    private final JumpingTime time = new JumpingTime();
    private final Journal journal = new Journal(new SystemTime());
    private final LateTaps taps = new LateTaps();
    private final TestCloud cloud = new TestCloud(0, taps);
    private final Outlet outlet;
    private final MatrixVehicle vehicle;
    private final DroneId drone;
    private final MatrixClient client;
    private final MatrixClient watcher;

    /** Who sends, and who has control of the drone. */
    record Cast(Optional<Role> role, boolean inControl, boolean atPersonalPort) {
        Cast(Optional<Role> role, boolean inControl) {
            this(role, inControl, false);
        }
    }

    MatrixHouse(Cast cast) throws IOException {
        Map<String, Principal> users = Map.of(
                "sender", new Principal("sender", cast.role().orElse(Role.REPORTER)),
                "holder", new Principal("holder", Role.OPERATOR),
                "watcher", new Principal("watcher", Role.VIEWER));
        KeptOutlet store = new KeptOutlet();
        OutletPolicy policy = new OutletPolicy(
                cloud.cloud(),
                store,
                journal,
                user -> Optional.ofNullable(users.get(user)),
                (by, drone, event) -> cloud.cloud().controls().apply(drone, event),
                time);
        outlet = new Outlet(List.of(), policy, Doors.of(DtlsKeys.none()));
        taps.outlet = outlet;
        users.keySet().forEach(user -> outlet.putKey(user, MatrixClient.key(user)));
        outlet.start(false);
        vehicle = new MatrixVehicle(cloud.udpPort());
        drone = cloud.awaitDrone(state -> state.capabilities().known()).id();
        String holder = cast.inControl() ? "sender" : "holder";
        cloud.cloud().controls().apply(drone, new LeaseEvent.Take(holder));
        watcher = attached("watcher", 253);
        client = cast.atPersonalPort()
                ? attached("sender", personal())
                : cast.role().isPresent() ? attached("sender", 254) : new MatrixClient(outlet, null, 254);
        is(MatrixVehicle.State.DISARMED);
        cloud.awaitDrone(state -> state.mission().items() != null);
    }

    private MatrixClient attached(String user, int systemId) {
        return attached(user, new MatrixClient(outlet, user, systemId));
    }

    private MatrixClient personal() {
        PersonalPort.Terms terms = new PersonalPort.Terms(
                "port-1", "sender", AddressRange.parse("192.0.2.1"), Instant.MIN, Instant.MAX, Long.MAX_VALUE);
        return new MatrixClient(new PersonalPort(outlet, terms, () -> 0), null, 254);
    }

    private static MatrixClient attached(String user, MatrixClient attached) {
        attached.says(GROUND);
        TestCloud.await(PATIENCE, attached::seesAVehicle, () -> user + " sees no vehicle");
        return attached;
    }

    void is(MatrixVehicle.State wanted) {
        vehicle.is(wanted);
        cloud.awaitDrone(
                state -> Boolean.valueOf(wanted != MatrixVehicle.State.DISARMED).equals(state.armed())
                        && state.airborne() == wanted.flies()
                        && "LOITER".equals(state.mode()) == (wanted == MatrixVehicle.State.STEERED)
                        && state.home() != null);
    }

    /** What comes in at the vehicle's socket because of what is said meanwhile: each kind once. */
    Set<String> reached(List<Message> words) {
        time.jump(Duration.ofNanos(SECOND_NANOS));
        int before = vehicle.heard().size();
        long holds = cloud.holdsBeyondSticks();
        words.forEach(client::says);
        watch();
        await(
                () -> cloud.commandsUnderWay() == 0 && cloud.holdsBeyondSticks() >= holds,
                "a command does not end, or nothing holds what was steered");
        // All that left has arrived.
        await(() -> vehicle.heard().size() == taps.said.size(), "a frame was lost on the way");
        Set<String> kinds = new TreeSet<>();
        // More may come meanwhile.
        List<Frame> heard = List.copyOf(vehicle.heard());
        for (Frame frame : heard.subList(before, heard.size())) {
            if (!isOfTheCloud(frame, before)) {
                kinds.add(name(frame));
            }
        }
        return kinds;
    }

    /** Returns when all that was said before was taken, and given at the gate: what a viewer asks for after it is refused. */
    private void watch() {
        int refusals = watcher.refusals();
        watcher.says(new CommandLong(1, 1, HOLD, 0, 0, 0, 0, 0, 0, 0, 0));
        await(() -> watcher.refusals() > refusals, "nobody is refused");
        // What went to the drone's lane without waiting is done before this.
        String sentence = "look " + refusals;
        cloud.cloud().say(drone, Severity.INFO, sentence);
        cloud.awaitDrone(state ->
                state.messages().stream().anyMatch(message -> message.text().equals(sentence)));
        // Else nothing would seem to be under way because nothing is written down yet.
        cloud.awaitWritten();
    }

    /** There are thousands of these: it looks often. */
    private static void await(BooleanSupplier wanted, String otherwise) {
        long deadline = System.nanoTime() + PATIENCE.toNanos();
        while (!wanted.getAsBoolean()) {
            if (System.nanoTime() > deadline) {
                throw new AssertionError(otherwise);
            }
            LockSupport.parkNanos(LOOK_NANOS);
        }
    }

    /**
     * What the cloud does of its own accord, frame by frame: nobody asked for it. Looked for among the latest alone: a frame
     * long ago may have had the same sequence number, and so the same bytes.
     */
    private boolean isOfTheCloud(Frame frame, int before) {
        Said own = new Said(HexFormat.of().formatHex(frame.bytes()), true);
        synchronized (taps.said) {
            return taps.said
                    .subList(Math.max(0, before - ASTRAY), taps.said.size())
                    .contains(own);
        }
    }

    private static String name(Frame frame) {
        if (frame.messageId() == CommandLong.ID) {
            return "COMMAND_LONG " + CommandLong.decode(frame).command();
        }
        if (frame.messageId() == CommandInt.ID) {
            return "COMMAND_INT " + CommandInt.decode(frame).command();
        }
        MessageTable.Entry entry = MessageTable.find(frame.messageId());
        return entry == null ? Integer.toString(frame.messageId()) : MatrixTable.name(entry);
    }

    @Override
    public void close() throws IOException {
        outlet.close();
        vehicle.close();
        cloud.close();
        journal.close();
    }

    /** The outlet is built of the cloud that it taps; beside it, this hears what leaves, and at whose word. */
    private static final class LateTaps implements FrameTap.Factory {
        private final List<Said> said = Collections.synchronizedList(new ArrayList<>());
        private volatile Outlet outlet;

        @Override
        public FrameTap open(int componentId) {
            return FrameTap.both(new Hearing(said), outlet.open(componentId));
        }
    }

    private record Said(String bytes, boolean ofTheCloud) {}

    private record Hearing(List<Said> frames) implements FrameTap {
        @Override
        public void heard(Frame frame) {}

        @Override
        public void said(byte[] frame, Mandate mandate) {
            frames.add(new Said(HexFormat.of().formatHex(frame), mandate.command() == null));
        }

        @Override
        public void bound(DroneId drone) {}

        @Override
        public void ended() {}
    }
}
