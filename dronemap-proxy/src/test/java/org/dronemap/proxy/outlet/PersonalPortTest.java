package org.dronemap.proxy.outlet;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketTimeoutException;
import java.net.URI;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.time.RealTime;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.TestCloud;
import org.dronemap.proxy.endpoint.DtlsKeys;
import org.dronemap.proxy.endpoint.EndpointSecurity;
import org.dronemap.proxy.endpoint.EndpointUrl;
import org.dronemap.proxy.outlet.client.OutletStatus;
import org.dronemap.proxy.outlet.rights.AddressRange;
import org.dronemap.proxy.outlet.rights.PortRange;
import org.dronemap.proxy.session.FrameTap;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Personal ports on real sockets: whose they are, what they show, and how they end. */
class PersonalPortTest {
    private static final Duration PATIENCE = Duration.ofSeconds(20);
    private static final Duration HOUR = Duration.ofHours(1);
    private static final DroneId DRONE = new DroneId("drone-1");
    private static final Heartbeat VEHICLE = new Heartbeat(2, 3, 81, 0, 3, 3);
    private static final Heartbeat GROUND = new Heartbeat(6, 8, 0, 0, 4, 3);
    private static final AddressRange HERE = AddressRange.parse("127.0.0.1");

    private final Map<String, Principal> users = new ConcurrentHashMap<>();
    private final JumpingTime time = new JumpingTime();
    private final TestCloud cloud = new TestCloud(0);
    private final StoreWriter journal = new StoreWriter(new RealTime());
    private final List<DatagramSocket> sockets = new ArrayList<>();
    private final FrameWriter ground = new FrameWriter(245, 190, 2);
    private final FrameWriter vehicle = new FrameWriter(7, 1, 2);
    private Outlet outlet;
    private FrameTap tap;

    @BeforeEach
    void start() throws IOException {
        users.put("ann", new Principal("ann", Role.OPERATOR));
        OutletDependencies policy = new OutletDependencies(
                cloud.cloud(),
                new TestOutletStore(),
                journal,
                user -> Optional.ofNullable(users.get(user)),
                (by, drone, event) -> cloud.cloud().controls().apply(drone, event),
                time);
        int first = freePort();
        outlet = new Outlet(
                List.of(EndpointUrl.parse("udpserver://127.0.0.1:0")),
                new PortRange(first, Math.min(65_535, first + 40)),
                policy,
                EndpointSecurity.of(DtlsKeys.none()));
        outlet.start(false);
        tap = outlet.open(1);
        tap.bound(DRONE);
    }

    private static int freePort() throws IOException {
        try (DatagramSocket probe = new DatagramSocket(0, InetAddress.getByName("127.0.0.1"))) {
            return probe.getLocalPort();
        }
    }

    @AfterEach
    void close() {
        outlet.close();
        sockets.forEach(DatagramSocket::close);
        journal.close();
        cloud.close();
    }

    @Test
    void showsUnsignedWhatItsUserMaySeeToTheFirstWhoSpeaksThere() throws IOException {
        OutletStatus.Port port = outlet.openPort("ann", HERE, HOUR);
        DatagramSocket first = socket("127.0.0.1");
        say(first, port);
        attached(1);
        tap.admitted(read(vehicle.frame(VEHICLE)));
        Frame heard = ofVehicle(first);
        assertThat(heard.systemId()).isEqualTo(7);
        assertThat(heard.signed()).isFalse();
        assertThat(now(port).peer()).isEqualTo("127.0.0.1:" + first.getLocalPort());
    }

    @Test
    void everybodyElseIsCountedAndHearsNothing() throws IOException {
        OutletStatus.Port port = outlet.openPort("ann", HERE, HOUR);
        DatagramSocket elsewhere = socket("127.0.0.2");
        say(elsewhere, port);
        TestCloud.await(PATIENCE, () -> now(port).refused() == 1, () -> "it is not counted");
        assertThat(now(port).peer()).isNull();
        DatagramSocket first = socket("127.0.0.1");
        say(first, port);
        attached(1);
        DatagramSocket second = socket("127.0.0.1");
        say(second, port);
        TestCloud.await(PATIENCE, () -> now(port).refused() == 2, () -> "the second is not counted");
        assertThat(outlet.status().refused().elsewhere()).isEqualTo(2);
        tap.admitted(read(vehicle.frame(VEHICLE)));
        assertThat(ofVehicle(first).systemId()).isEqualTo(7);
        assertNothingCame(elsewhere);
        assertNothingCame(second);
    }

    @Test
    void whatIsNoMessageGivesItToNobody() throws IOException {
        OutletStatus.Port port = outlet.openPort("ann", HERE, HOUR);
        DatagramSocket noise = socket("127.0.0.1");
        send(noise, port, new byte[] {1, 2, 3});
        DatagramSocket first = socket("127.0.0.1");
        say(first, port);
        attached(1);
        assertThat(now(port).peer()).isEqualTo("127.0.0.1:" + first.getLocalPort());
    }

    @Test
    void endsWhenItIsClosedOrItsTimeIsUpOrItsUserMayLookNoMore() throws IOException {
        OutletStatus.Port closed = outlet.openPort("ann", HERE, HOUR);
        say(socket("127.0.0.1"), closed);
        attached(1);
        assertThat(outlet.closePort(closed.id())).isTrue();
        assertThat(outlet.closePort(closed.id())).isFalse();
        attached(0);

        OutletStatus.Port over = outlet.openPort("ann", HERE, HOUR);
        say(socket("127.0.0.1"), over);
        attached(1);
        time.jump(HOUR);
        TestCloud.await(PATIENCE, () -> outlet.status().ports().isEmpty(), () -> "it is open for ever");
        attached(0);

        say(socket("127.0.0.1"), outlet.openPort("ann", HERE, HOUR));
        attached(1);
        users.put("ann", new Principal("ann", Role.REPORTER));
        attached(0);
        outlet.closePortsOf("ann");
        assertThat(outlet.status().ports()).isEmpty();
    }

    @Test
    void thereAreFewOfAUserAndNoneWhereTheServerOpensNone() {
        for (int count = 0; count < 3; count++) {
            outlet.openPort("ann", HERE, HOUR);
        }
        assertThatIllegalStateException()
                .isThrownBy(() -> outlet.openPort("ann", HERE, HOUR))
                .withMessageContaining("close one first");
        try (Outlet none = new Outlet(
                List.of(EndpointUrl.parse("udpserver://127.0.0.1:0")),
                policyOfNobody(),
                EndpointSecurity.of(DtlsKeys.none()))) {
            assertThatIllegalStateException()
                    .isThrownBy(() -> none.openPort("bob", HERE, HOUR))
                    .withMessage("This server opens no personal ports.");
        }
    }

    private OutletDependencies policyOfNobody() {
        return new OutletDependencies(
                cloud.cloud(),
                new TestOutletStore(),
                journal,
                user -> Optional.empty(),
                (by, drone, event) -> cloud.cloud().controls().apply(drone, event),
                time);
    }

    private void attached(int count) {
        TestCloud.await(
                PATIENCE, () -> outlet.status().clients().size() == count, () -> "there are not " + count + " clients");
    }

    private OutletStatus.Port now(OutletStatus.Port port) {
        return outlet.status().ports().stream()
                .filter(other -> other.id().equals(port.id()))
                .findFirst()
                .orElseThrow();
    }

    private DatagramSocket socket(String host) throws IOException {
        DatagramSocket socket = new DatagramSocket(0, InetAddress.getByName(host));
        socket.setSoTimeout((int) PATIENCE.toMillis());
        sockets.add(socket);
        return socket;
    }

    private void say(DatagramSocket socket, OutletStatus.Port port) throws IOException {
        send(socket, port, ground.frame(GROUND));
    }

    private static void send(DatagramSocket socket, OutletStatus.Port port, byte[] bytes) throws IOException {
        URI url = URI.create(port.endpoint());
        socket.send(new DatagramPacket(bytes, bytes.length, new InetSocketAddress(url.getHost(), url.getPort())));
    }

    /** The next that is not the cloud's own. */
    private static Frame ofVehicle(DatagramSocket socket) throws IOException {
        while (true) {
            Frame frame = next(socket);
            if (frame.systemId() < 240) {
                return frame;
            }
        }
    }

    private static Frame next(DatagramSocket socket) throws IOException {
        DatagramPacket packet = new DatagramPacket(new byte[300], 300);
        socket.receive(packet);
        List<Frame> frames = new ArrayList<>();
        new FrameReader().readDatagram(ByteBuffer.wrap(packet.getData(), 0, packet.getLength()), frames::add);
        return frames.get(0);
    }

    private static Frame read(byte[] raw) {
        List<Frame> frames = new ArrayList<>();
        new FrameReader().read(ByteBuffer.wrap(raw), frames::add);
        return frames.get(0);
    }

    private static void assertNothingCame(DatagramSocket socket) throws IOException {
        socket.setSoTimeout(1);
        try {
            throw new AssertionError("it heard " + next(socket).messageId());
        } catch (SocketTimeoutException nothing) {
            // As it shall be.
        }
    }
}
