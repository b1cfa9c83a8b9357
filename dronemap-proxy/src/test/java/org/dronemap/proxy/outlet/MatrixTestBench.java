package org.dronemap.proxy.outlet;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.SendAuthority;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.time.SteppedTime;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.MessageTable;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.TestCloud;
import org.dronemap.proxy.endpoint.DtlsKeys;
import org.dronemap.proxy.endpoint.EndpointSecurity;
import org.dronemap.proxy.outlet.rights.AddressRange;
import org.dronemap.proxy.session.FrameTap;
import org.jspecify.annotations.Nullable;

/** A cloud with one vehicle, its outlet, and somebody at it, in stepped time; tells what gets through to the vehicle. */
final class MatrixTestBench implements AutoCloseable {
    /** What fills messages that mean nothing in particular: the cloud says nothing of its own with it. */
    static final int FILL = 0x2A;

    private static final Duration PATIENCE = Duration.ofSeconds(20);
    private static final Heartbeat GROUND = new Heartbeat(6, 8, 0, 0, 4, 3);
    /** Fewer than there are sequence numbers. */
    private static final int ASTRAY = 64;

    /** The cloud counts some things by the second. */
    private static final Duration ANOTHER_SECOND = Duration.ofMillis(1_100);
    /** All that is said is taken, given at the gate and written down by then. */
    private static final Duration SOON = Duration.ofMillis(50);

    private final SteppedTime time = new SteppedTime(Instant.parse("2026-03-04T05:06:07Z"));
    private final StoreWriter journal = new StoreWriter(time);
    private final LateTaps taps = new LateTaps();
    private final TestCloud cloud = new TestCloud(taps, time);
    private final Outlet outlet;
    private final MatrixVehicle vehicle;
    private final DroneId drone;
    private final String holder;
    private final MatrixClient client;

    /** Who sends, and who has control of the drone. */
    record Sender(Optional<Role> role, boolean inControl, boolean atPersonalPort) {
        Sender(Optional<Role> role, boolean inControl) {
            this(role, inControl, false);
        }
    }

    MatrixTestBench(Sender cast) throws IOException {
        Map<String, Principal> users = Map.of(
                "sender", new Principal("sender", cast.role().orElse(Role.REPORTER)),
                "holder", new Principal("holder", Role.OPERATOR));
        TestOutletStore store = new TestOutletStore();
        OutletDependencies policy = new OutletDependencies(
                cloud.cloud(),
                store,
                journal,
                user -> Optional.ofNullable(users.get(user)),
                (by, drone, event) -> cloud.cloud().controls().apply(drone, event),
                time);
        outlet = new Outlet(List.of(), policy, EndpointSecurity.of(DtlsKeys.none()));
        taps.outlet = outlet;
        users.keySet().forEach(user -> outlet.putKey(user, MatrixClient.key(user)));
        outlet.start(false);
        vehicle = new MatrixVehicle(cloud.proxy().handlers(), time);
        drone = becomes(state -> state.capabilities().known()).id();
        holder = cast.inControl() ? "sender" : "holder";
        holderIsThere();
        client = cast.atPersonalPort()
                ? attached(personal())
                : cast.role().isPresent() ? attached(client("sender")) : client(null);
        is(MatrixVehicle.State.DISARMED);
        DroneState unused = becomes(state -> state.mission().items() != null);
    }

    /** Who gives no sign loses control. */
    private void holderIsThere() {
        cloud.cloud().controls().apply(drone, new LeaseEvent.TakeControl(holder));
    }

    private MatrixClient client(@Nullable String user) {
        return new MatrixClient(outlet, user, 254, null, time.clock());
    }

    /** The drone, once it looks as wanted. */
    private DroneState becomes(Predicate<DroneState> wanted) {
        await(() -> cloud.cloud().drones().stream().anyMatch(wanted), "no drone as wanted");
        return cloud.cloud().drones().get(0);
    }

    private MatrixClient personal() {
        PersonalPort.Terms terms = new PersonalPort.Terms(
                "port-1", "sender", AddressRange.parse("192.0.2.1"), Instant.MIN, Instant.MAX, Long.MAX_VALUE);
        return new MatrixClient(outlet.personalPort(terms), null, 254);
    }

    private MatrixClient attached(MatrixClient attached) {
        attached.says(GROUND);
        await(attached::seesAVehicle, "it sees no vehicle");
        return attached;
    }

    void is(MatrixVehicle.State wanted) {
        vehicle.is(wanted);
        DroneState unused = becomes(
                state -> Boolean.valueOf(wanted != MatrixVehicle.State.DISARMED).equals(state.armed())
                        && state.airborne() == wanted.flies()
                        && "LOITER".equals(state.mode()) == (wanted == MatrixVehicle.State.STEERED)
                        && state.home() != null);
    }

    /** What comes in at the vehicle because of what is said meanwhile: each kind once. */
    Set<String> reached(List<Message> words) {
        time.advance(ANOTHER_SECOND);
        holderIsThere();
        int before = vehicle.heard().size();
        long holds = cloud.holdsBeyondSticks();
        words.forEach(client::says);
        time.advance(SOON);
        await(
                () -> cloud.commandsUnderWay() == 0 && cloud.holdsBeyondSticks() >= holds,
                "a command does not end, or nothing holds what was steered");
        time.advance(SOON);
        if (vehicle.heard().size() != taps.said.size()) {
            throw new AssertionError("a frame was lost on the way");
        }
        Set<String> kinds = new TreeSet<>();
        List<Frame> heard = vehicle.heard();
        for (Frame frame : heard.subList(before, heard.size())) {
            if (!isOfTheCloud(frame, before)) {
                kinds.add(name(frame));
            }
        }
        return kinds;
    }

    private void await(BooleanSupplier wanted, String otherwise) {
        if (!time.advanceUntil(wanted, PATIENCE)) {
            throw new AssertionError(otherwise + ": " + cloud.cloud().drones());
        }
    }

    /**
     * What the cloud does of its own accord, frame by frame: nobody asked for it. Looked for among the latest alone: a frame
     * long ago may have had the same sequence number, and so the same bytes.
     */
    private boolean isOfTheCloud(Frame frame, int before) {
        SentFrame own = new SentFrame(HexFormat.of().formatHex(frame.bytes()), true);
        return taps.said.subList(Math.max(0, before - ASTRAY), taps.said.size()).contains(own);
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
        private final List<SentFrame> said = new ArrayList<>();
        private volatile Outlet outlet;

        @Override
        public FrameTap open(int componentId) {
            return FrameTap.both(new SentFrameTap(said), outlet.open(componentId));
        }
    }

    private record SentFrame(String bytes, boolean ofTheCloud) {}

    private record SentFrameTap(List<SentFrame> frames) implements FrameTap {
        @Override
        public void received(Frame frame) {}

        @Override
        public void sent(byte[] frame, SendAuthority mandate) {
            frames.add(new SentFrame(HexFormat.of().formatHex(frame), mandate.command() == null));
        }

        @Override
        public void bound(DroneId drone) {}

        @Override
        public void ended() {}
    }
}
