package org.dronemap.proxy.endpoint;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.time.Duration;
import org.dronemap.core.time.RealTime;
import org.dronemap.proxy.TestCloud;
import org.junit.jupiter.api.Test;

/** Lines that this end makes: UDP and TCP clients on real sockets. */
class ClientEndpointTest {
    private static final Duration PATIENCE = Duration.ofSeconds(10);

    private final CountingPeerHandlers gathering = new CountingPeerHandlers();

    private Endpoint open(String url) throws IOException {
        return Endpoint.open(EndpointUrl.parse(url), gathering, EndpointSecurity.of(DtlsKeys.none()), new RealTime());
    }

    @Test
    void greetsASilentVehicleAndHearsItsAnswerByUdp() throws IOException {
        try (DatagramSocket vehicle = new DatagramSocket(0, InetAddress.getLoopbackAddress());
                Endpoint endpoint = open("udpclient://127.0.0.1:" + vehicle.getLocalPort())) {
            vehicle.setSoTimeout(5_000);
            DatagramPacket greeting = new DatagramPacket(new byte[100], 100);
            vehicle.receive(greeting);
            vehicle.send(new DatagramPacket(new byte[] {1, 2, 3, 4}, 4, greeting.getSocketAddress()));
            TestCloud.await(PATIENCE, () -> gathering.bytes() == 4, () -> "not heard");

            assertThat(greeting.getLength()).isEqualTo(CountingPeerHandlers.GREETING.length);
            assertThat(gathering.guests().get(0).peer().address())
                    .isEqualTo(new PeerAddress("127.0.0.1", vehicle.getLocalPort()));
            assertThat(gathering.guests().get(0).peer().isLocal()).isTrue();
            assertThat(endpoint.state()).isEqualTo(EndpointState.OPEN);
        }
    }

    @Test
    void aUdpClientHearsNobodyButTheOneItCalls() throws IOException {
        try (DatagramSocket vehicle = new DatagramSocket(0, InetAddress.getLoopbackAddress());
                DatagramSocket stranger = new DatagramSocket(0, InetAddress.getLoopbackAddress());
                Endpoint endpoint = open("udpclient://127.0.0.1:" + vehicle.getLocalPort())) {
            vehicle.setSoTimeout(5_000);
            DatagramPacket greeting = new DatagramPacket(new byte[100], 100);
            vehicle.receive(greeting);
            stranger.send(new DatagramPacket(new byte[50], 50, greeting.getSocketAddress()));
            vehicle.send(new DatagramPacket(new byte[4], 4, greeting.getSocketAddress()));
            TestCloud.await(PATIENCE, () -> gathering.bytes() >= 4, () -> "not heard");

            assertThat(gathering.bytes()).isEqualTo(4);
            assertThat(endpoint.counters().counts().peers()).isEqualTo(1);
        }
    }

    @Test
    void comesBackWhenTheOtherSideClosesItsTcpConnection() throws IOException {
        try (ServerSocket vehicle = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
                Endpoint endpoint = open("tcpclient://127.0.0.1:" + vehicle.getLocalPort())) {
            vehicle.setSoTimeout(10_000);
            try (Socket first = vehicle.accept()) {
                first.getOutputStream().write(new byte[] {1, 2});
                TestCloud.await(PATIENCE, () -> gathering.bytes() == 2, () -> "not heard");
            }
            try (Socket second = vehicle.accept()) {
                second.getOutputStream().write(new byte[] {1, 2, 3});
                TestCloud.await(PATIENCE, () -> gathering.bytes() == 5, () -> "not heard again");
                assertThat(endpoint.state()).isEqualTo(EndpointState.OPEN);
            }
            assertThat(gathering.guests()).hasSize(2);
            assertThat(gathering.guests().get(0).isClosed()).isTrue();
        }
    }

    @Test
    void saysWhyThereIsNoTcpConnectionAndConnectsOnceThereIsSomebody() throws IOException {
        int port = UnusedPorts.free();
        try (Endpoint endpoint = open("tcpclient://127.0.0.1:" + port)) {
            TestCloud.await(
                    PATIENCE,
                    () -> endpoint.state().phase() == EndpointState.Phase.FAILED,
                    () -> "it is " + endpoint.state());
            assertThat(endpoint.state().reason())
                    .contains("tcpclient://127.0.0.1:" + port)
                    .contains("refused");

            try (ServerSocket vehicle = new ServerSocket()) {
                vehicle.setReuseAddress(true);
                vehicle.bind(new InetSocketAddress("127.0.0.1", port));
                TestCloud.await(
                        PATIENCE, () -> endpoint.state().equals(EndpointState.OPEN), () -> "it is " + endpoint.state());
            }
        }
    }
}
