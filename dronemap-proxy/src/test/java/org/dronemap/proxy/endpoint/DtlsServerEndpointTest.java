package org.dronemap.proxy.endpoint;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.dronemap.core.time.RealTime;
import org.dronemap.proxy.TestCloud;
import org.eclipse.californium.elements.AddressEndpointContext;
import org.eclipse.californium.elements.RawData;
import org.eclipse.californium.elements.config.Configuration;
import org.eclipse.californium.scandium.DTLSConnector;
import org.eclipse.californium.scandium.config.DtlsConfig;
import org.eclipse.californium.scandium.config.DtlsConnectorConfig;
import org.eclipse.californium.scandium.dtls.SingleNodeConnectionIdGenerator;
import org.eclipse.californium.scandium.dtls.pskstore.AdvancedSinglePskStore;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Authenticated links, against the library's own client. */
class DtlsServerEndpointTest {
    private static final Duration PATIENCE = Duration.ofSeconds(10);
    private static final byte[] SECRET = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};

    private final CountingPeerHandlers gathering = new CountingPeerHandlers();
    private final Map<String, byte[]> keys = new ConcurrentHashMap<>(Map.of("copter", SECRET, "plane", SECRET));
    private Endpoint endpoint;

    @BeforeEach
    void open() throws IOException {
        endpoint = Endpoint.open(
                EndpointUrl.parse("dtlsserver://127.0.0.1:0"),
                gathering,
                EndpointSecurity.of(
                        identity -> Optional.ofNullable(keys.get(identity)).map(byte[]::clone)),
                new RealTime());
    }

    @AfterEach
    void close() {
        endpoint.close();
    }

    /** A vehicle with a key, sending to a port. */
    private static final class Vehicle implements AutoCloseable {
        private final DTLSConnector connector;
        private final InetSocketAddress server;
        private final LinkedBlockingQueue<Integer> heard = new LinkedBlockingQueue<>();

        Vehicle(String identity, byte[] secret, int port) throws IOException {
            Configuration defaults = new Configuration(DtlsConfig.DEFINITIONS);
            connector = new DTLSConnector(DtlsConnectorConfig.builder(defaults)
                    .setAddress(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0))
                    .set(DtlsConfig.DTLS_ROLE, DtlsConfig.DtlsRole.CLIENT_ONLY)
                    .setConnectionIdGenerator(new SingleNodeConnectionIdGenerator(0))
                    .setAdvancedPskStore(new AdvancedSinglePskStore(identity, secret))
                    .build());
            connector.setRawDataReceiver(data -> heard.add((int) data.getBytes()[0]));
            connector.start();
            server = new InetSocketAddress(InetAddress.getLoopbackAddress(), port);
        }

        void send(int bytes) {
            connector.send(RawData.outbound(new byte[bytes], new AddressEndpointContext(server), null, false));
        }

        @Override
        public void close() {
            connector.destroy();
        }
    }

    @Test
    void provesWhoTheVehicleIsAndAnswersIt() throws Exception {
        try (Vehicle copter = new Vehicle("copter", SECRET, endpoint.url().port())) {
            copter.send(5);

            assertThat(copter.heard.poll(10, TimeUnit.SECONDS)).isEqualTo(1);
            Peer peer = gathering.guests().get(0).peer();
            assertThat(peer.authenticatedIdentity()).contains("copter");
            assertThat(peer.transport()).isEqualTo("dtls");
            assertThat(gathering.bytes()).isEqualTo(5);
        }
    }

    @Test
    void letsNobodyInWithAWrongKeyOrAnUnknownName() throws Exception {
        try (Vehicle wrong = new Vehicle("copter", new byte[16], endpoint.url().port());
                Vehicle unknown = new Vehicle("nobody", SECRET, endpoint.url().port());
                Vehicle plane = new Vehicle("plane", SECRET, endpoint.url().port())) {
            wrong.send(5);
            unknown.send(5);
            plane.send(3);

            assertThat(plane.heard.poll(10, TimeUnit.SECONDS)).isEqualTo(1);
            assertThat(wrong.heard.poll(1, TimeUnit.SECONDS)).isNull();
            assertThat(unknown.heard.poll(1, TimeUnit.SECONDS)).isNull();
            assertThat(gathering.guests()).hasSize(1);
            assertThat(gathering.bytes()).isEqualTo(3);
        }
    }

    @Test
    void keepsThePeerWhenItsAddressChanges() throws Exception {
        try (Nat nat = new Nat(endpoint.url().port());
                Vehicle copter = new Vehicle("copter", SECRET, nat.port())) {
            copter.send(5);
            assertThat(copter.heard.poll(10, TimeUnit.SECONDS)).isEqualTo(1);
            PeerAddress before = gathering.guests().get(0).peer().address();
            nat.rebind();
            copter.send(7);
            assertThat(copter.heard.poll(10, TimeUnit.SECONDS)).isEqualTo(1);

            assertThat(gathering.guests()).hasSize(1);
            assertThat(gathering.bytes()).isEqualTo(12);
            assertThat(gathering.guests().get(0).peer().address()).isNotEqualTo(before);
            assertThat(endpoint.peers()).hasSize(1);
        }
    }

    @Test
    void aRevokedKeyEndsItsLinksAndOpensNoNewOnes() throws Exception {
        try (Vehicle copter = new Vehicle("copter", SECRET, endpoint.url().port());
                Vehicle plane = new Vehicle("plane", SECRET, endpoint.url().port())) {
            copter.send(5);
            plane.send(5);
            TestCloud.await(PATIENCE, () -> gathering.guests().size() == 2, () -> "not both are there");
            keys.remove("copter");
            endpoint.disconnect("copter");
            TestCloud.await(PATIENCE, () -> endpoint.peers().size() == 1, () -> "it is still there");

            copter.send(100);
            plane.send(1);
            TestCloud.await(PATIENCE, () -> gathering.bytes() == 11, () -> "heard " + gathering.bytes());
            assertThat(endpoint.peers().get(0).identity()).isEqualTo("plane");
        }
    }

    /** Passes datagrams on, from one outside address and later from another. */
    private static final class Nat implements AutoCloseable {
        private final DatagramSocket inside = new DatagramSocket(0, InetAddress.getLoopbackAddress());
        private final int server;
        private volatile DatagramSocket outside;
        private volatile InetSocketAddress vehicle;

        Nat(int server) throws IOException {
            this.server = server;
            outside = outside();
            Thread up = new Thread(() -> relay(inside), "nat-up");
            up.setDaemon(true);
            up.start();
        }

        private DatagramSocket outside() throws IOException {
            DatagramSocket socket = new DatagramSocket(0, InetAddress.getLoopbackAddress());
            Thread down = new Thread(() -> relay(socket), "nat-down");
            down.setDaemon(true);
            down.start();
            return socket;
        }

        private void relay(DatagramSocket from) {
            DatagramPacket packet = new DatagramPacket(new byte[65_536], 65_536);
            try {
                while (!from.isClosed()) {
                    packet.setLength(65_536);
                    from.receive(packet);
                    if (from.equals(inside)) {
                        vehicle = (InetSocketAddress) packet.getSocketAddress();
                        packet.setSocketAddress(new InetSocketAddress(InetAddress.getLoopbackAddress(), server));
                        outside.send(packet);
                    } else {
                        packet.setSocketAddress(vehicle);
                        inside.send(packet);
                    }
                }
            } catch (IOException e) {
                if (!from.isClosed()) {
                    throw new IllegalStateException(e);
                }
            }
        }

        void rebind() throws IOException {
            DatagramSocket old = outside;
            outside = outside();
            old.close();
        }

        int port() {
            return inside.getLocalPort();
        }

        @Override
        public void close() {
            inside.close();
            outside.close();
        }
    }
}
