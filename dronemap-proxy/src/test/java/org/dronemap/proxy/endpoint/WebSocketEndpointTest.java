package org.dronemap.proxy.endpoint;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.dronemap.core.time.RealTime;
import org.dronemap.proxy.TestCloud;
import org.junit.jupiter.api.Test;

/** WebSocket links: the server against Java's own client, then the client against the server. */
class WebSocketEndpointTest {
    private static final Duration PATIENCE = Duration.ofSeconds(10);

    private final CountingPeerHandlers gathering = new CountingPeerHandlers();

    /** Keeps what comes, and that it ended. */
    private static final class Vehicle implements WebSocket.Listener {
        private final LinkedBlockingQueue<Integer> heard = new LinkedBlockingQueue<>();
        private final CompletableFuture<Integer> closed = new CompletableFuture<>();

        @Override
        public CompletionStage<?> onBinary(WebSocket socket, ByteBuffer data, boolean last) {
            heard.add((int) data.get());
            socket.request(1);
            return CompletableFuture.completedStage(null);
        }

        @Override
        public CompletionStage<?> onClose(WebSocket socket, int code, String reason) {
            closed.complete(code);
            return CompletableFuture.completedStage(null);
        }
    }

    private Endpoint open(String url) throws IOException {
        return Endpoint.open(EndpointUrl.parse(url), gathering, EndpointSecurity.of(DtlsKeys.none()), new RealTime());
    }

    private static CompletableFuture<WebSocket> connect(Endpoint endpoint, Vehicle vehicle, String... headers) {
        WebSocket.Builder builder = HttpClient.newHttpClient().newWebSocketBuilder();
        for (int header = 0; header < headers.length; header += 2) {
            builder.header(headers[header], headers[header + 1]);
        }
        return builder.buildAsync(URI.create("ws://127.0.0.1:" + endpoint.url().port() + "/mavlink"), vehicle);
    }

    @Test
    void carriesBytesBothWaysAndNoticesThatTheVehicleLeft() throws Exception {
        try (Endpoint endpoint = open("wsserver://127.0.0.1:0")) {
            Vehicle vehicle = new Vehicle();
            WebSocket socket = connect(endpoint, vehicle).get(10, TimeUnit.SECONDS);
            socket.sendBinary(ByteBuffer.wrap(new byte[] {1, 2, 3}), true).get(10, TimeUnit.SECONDS);

            assertThat(vehicle.heard.poll(10, TimeUnit.SECONDS)).isEqualTo(1);
            assertThat(gathering.bytes()).isEqualTo(3);
            assertThat(gathering.guests().get(0).peer().transport()).isEqualTo("websocket");
            socket.sendClose(WebSocket.NORMAL_CLOSURE, "").get(10, TimeUnit.SECONDS);
            TestCloud.await(PATIENCE, () -> gathering.guests().get(0).isClosed(), () -> "not noticed");
            assertThat(endpoint.counters().counts().peers()).isZero();
        }
    }

    @Test
    void letsNoWebPageIn() throws Exception {
        try (Endpoint endpoint = open("wsserver://127.0.0.1:0")) {
            CompletableFuture<WebSocket> page = connect(endpoint, new Vehicle(), "Origin", "https://elsewhere.example");

            assertThat(page).failsWithin(PATIENCE);
            assertThat(gathering.guests()).isEmpty();
            assertThat(endpoint.counters().counts().refusedPeers()).isEqualTo(1);
        }
    }

    @Test
    void sendsAwayWhoSpeaksText() throws Exception {
        try (Endpoint endpoint = open("wsserver://127.0.0.1:0")) {
            Vehicle vehicle = new Vehicle();
            connect(endpoint, vehicle).get(10, TimeUnit.SECONDS).sendText("{}", true);

            assertThat(vehicle.closed.get(10, TimeUnit.SECONDS)).isEqualTo(1003);
        }
    }

    @Test
    void dropsAndCountsFramesForAVehicleThatDoesNotRead() throws Exception {
        try (Endpoint endpoint = open("wsserver://127.0.0.1:0");
                java.net.Socket socket =
                        new java.net.Socket("127.0.0.1", endpoint.url().port())) {
            socket.setReceiveBufferSize(2_048);
            String request = "GET / HTTP/1.1\r\nHost: x\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                    + "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\nSec-WebSocket-Version: 13\r\n\r\n";
            socket.getOutputStream().write(request.getBytes(java.nio.charset.StandardCharsets.US_ASCII));
            TestCloud.await(PATIENCE, () -> gathering.guests().size() == 1, () -> "not connected");
            Peer peer = gathering.guests().get(0).peer();
            for (int count = 0; count < 200_000; count++) {
                peer.send(new byte[280]);
            }

            assertThat(endpoint.counters().counts().droppedOut()).isGreaterThan(10_000);
            assertThat(endpoint.peers().get(0).queue()).isLessThanOrEqualTo(256);
        }
    }

    @Test
    void dialsAWebSocketAndComesBackWhenItBreaks() throws Exception {
        CountingPeerHandlers far = new CountingPeerHandlers();
        EndpointUrl url = EndpointUrl.parse("wsserver://127.0.0.1:" + UnusedPorts.free());
        Endpoint vehicles = Endpoint.open(url, far, EndpointSecurity.of(DtlsKeys.none()), new RealTime());
        try (Endpoint endpoint = open("wsclient://127.0.0.1:" + url.port() + "/vehicle")) {
            TestCloud.await(PATIENCE, () -> far.bytes() >= 3, () -> "not greeted");
            TestCloud.await(PATIENCE, () -> gathering.bytes() >= 1, () -> "not answered");
            assertThat(endpoint.state()).isEqualTo(EndpointState.OPEN);
            vehicles.close();
            TestCloud.await(
                    PATIENCE,
                    () -> endpoint.state().phase() == EndpointState.Phase.FAILED,
                    () -> "it is " + endpoint.state());

            vehicles = Endpoint.open(url, far, EndpointSecurity.of(DtlsKeys.none()), new RealTime());
            TestCloud.await(
                    PATIENCE, () -> endpoint.state().equals(EndpointState.OPEN), () -> "it is " + endpoint.state());
        } finally {
            vehicles.close();
        }
    }
}
