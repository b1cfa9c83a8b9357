package org.dronemap.proxy.endpoint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.KeyStore;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import javax.net.ssl.KeyManagerFactory;
import javax.net.ssl.SSLContext;
import javax.net.ssl.TrustManagerFactory;
import org.dronemap.core.process.PeerCrashGuard;
import org.dronemap.core.time.RealTime;
import org.dronemap.proxy.TestCloud;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The port for vehicles' WebSockets stays open to others whatever clients do before they have shaken hands. */
class BoundedWebSocketFactoryTest {
    private static final Duration PATIENCE = Duration.ofSeconds(30);

    private final CountingPeerHandlers gathering = new CountingPeerHandlers();

    private Endpoint open(BoundedWebSocketFactory.Limits limits) throws IOException {
        return Endpoint.open(
                EndpointUrl.parse("wsserver://127.0.0.1:0"),
                gathering,
                new EndpointSecurity(DtlsKeys.none(), () -> null, limits, PeerCrashGuard.NONE),
                new RealTime());
    }

    private static WebSocket connect(Endpoint endpoint) throws Exception {
        return HttpClient.newHttpClient()
                .newWebSocketBuilder()
                .buildAsync(URI.create("ws://127.0.0.1:" + endpoint.url().port() + "/"), new WebSocket.Listener() {})
                .get(30, TimeUnit.SECONDS);
    }

    private static Socket half(Endpoint endpoint) throws IOException {
        Socket socket =
                new Socket(InetAddress.getLoopbackAddress(), endpoint.url().port());
        socket.getOutputStream().write("GET / HTTP/1.1\r\nX-A: ".getBytes(StandardCharsets.US_ASCII));
        return socket;
    }

    private static boolean isClosed(Socket socket) {
        try {
            socket.setSoTimeout(1);
            return socket.getInputStream().read() < 0;
        } catch (SocketTimeoutException open) {
            return false;
        } catch (IOException closed) {
            return true;
        }
    }

    @Test
    void turnsAwayWhoIsTooManyAndTakesOthersAgainWhenThereIsRoom() throws Exception {
        try (Endpoint endpoint = open(new BoundedWebSocketFactory.Limits(10, 5, 10, 16_384, Duration.ofMinutes(5)))) {
            List<Socket> halves = new ArrayList<>();
            for (int count = 0; count < 8; count++) {
                halves.add(half(endpoint));
            }
            TestCloud.await(
                    PATIENCE,
                    () -> halves.stream()
                                    .filter(BoundedWebSocketFactoryTest::isClosed)
                                    .count()
                            == 3,
                    () -> "not three are turned away");
            assertThat(endpoint.counters().counts().refusedPeers()).isEqualTo(3);
            for (Socket socket : halves) {
                socket.close();
            }
            TestCloud.await(PATIENCE, () -> comesIn(endpoint), () -> "nobody comes in any more");
        }
    }

    private static boolean comesIn(Endpoint endpoint) {
        try {
            connect(endpoint).abort();
            return true;
        } catch (Exception turnedAway) {
            return false;
        }
    }

    @Test
    void cutsAHandshakeThatTakesTooLong() throws Exception {
        try (Endpoint endpoint = open(new BoundedWebSocketFactory.Limits(10, 5, 10, 16_384, Duration.ofMillis(500)));
                Socket slow = half(endpoint)) {
            WebSocket vehicle = connect(endpoint);

            TestCloud.await(PATIENCE, () -> isClosed(slow), () -> "still there");

            assertThat(vehicle.isInputClosed()).isFalse();
        }
    }

    @Test
    void cutsAHandshakeThatIsTooLong() throws Exception {
        try (Endpoint endpoint = open(BoundedWebSocketFactory.Limits.DEFAULT);
                Socket talkative = half(endpoint)) {
            assertThatThrownBy(() -> {
                        for (int said = 0; said < 10_000_000; said += 1_000) {
                            talkative.getOutputStream().write(new byte[1_000]);
                        }
                    })
                    .isInstanceOf(IOException.class);
        }
    }

    @Test
    void listensOnlyAfterAPauseToWhoComesFromWhereManyWereCutAndToOthersAtOnce() throws Exception {
        Duration longest = Duration.ofDays(1);
        try (Endpoint endpoint = open(new BoundedWebSocketFactory.Limits(100, 50, 50, 16_384, PATIENCE, longest))) {
            int port = endpoint.url().port();
            // The pauses double: after some of them it is longer than any test.
            TestCloud.await(PATIENCE, () -> !cameInAndWasCut(port), () -> "who was cut is heard again at once");
            try (Socket other = new Socket()) {
                other.bind(new InetSocketAddress("127.0.0.2", 0));
                other.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
                assertThat(isAnswered(other, PATIENCE)).isTrue();
            }
        }
    }

    @Test
    void turnsNobodyAwayWhoCameFromWhereManyWereCut() throws Exception {
        try (Endpoint endpoint =
                open(new BoundedWebSocketFactory.Limits(100, 50, 50, 16_384, PATIENCE, Duration.ofMillis(200)))) {
            for (int cut = 0; cut < 10; cut++) {
                exceed(endpoint.url().port());
            }
            assertThat(comesIn(endpoint)).isTrue();
        }
    }

    /** One more who is cut, if it is listened to within a second. */
    private static boolean cameInAndWasCut(int port) {
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
            boolean answered = isAnswered(socket, Duration.ofSeconds(1));
            if (answered) {
                exceed(socket);
            }
            return answered;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void exceed(int port) throws IOException {
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
            assertThat(isAnswered(socket, PATIENCE)).isTrue();
            exceed(socket);
        }
    }

    /** Announces more than anybody may say, and waits for the farewell. */
    private static void exceed(Socket socket) throws IOException {
        ByteBuffer frame = ByteBuffer.allocate(14);
        frame.put((byte) 0x82).put((byte) (0x80 | 127)).putLong(1L << 40);
        socket.getOutputStream().write(frame.array());
        socket.setSoTimeout((int) PATIENCE.toMillis());
        assertThat(socket.getInputStream().read()).isPositive();
    }

    private static boolean isAnswered(Socket socket, Duration patience) throws IOException {
        socket.getOutputStream()
                .write(("GET / HTTP/1.1\r\nHost: x\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                                + "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\nSec-WebSocket-Version: 13\r\n\r\n")
                        .getBytes(StandardCharsets.US_ASCII));
        socket.setSoTimeout((int) patience.toMillis());
        try {
            for (StringBuilder head = new StringBuilder(); head.indexOf("\r\n\r\n") < 0; ) {
                int next = socket.getInputStream().read();
                if (next < 0) {
                    return false;
                }
                head.append((char) next);
            }
            return true;
        } catch (SocketTimeoutException nothing) {
            return false;
        }
    }

    @Test
    void carriesBytesOverTlsWithTheCertificateOfTheMoment(@TempDir Path directory) throws Exception {
        SSLContext certificate = certificate(directory);
        EndpointSecurity doors = new EndpointSecurity(
                DtlsKeys.none(), () -> certificate, BoundedWebSocketFactory.Limits.DEFAULT, PeerCrashGuard.NONE);
        try (Endpoint endpoint =
                Endpoint.open(EndpointUrl.parse("wssserver://127.0.0.1:0"), gathering, doors, new RealTime())) {
            WebSocket vehicle = HttpClient.newBuilder()
                    .sslContext(certificate)
                    .build()
                    .newWebSocketBuilder()
                    .buildAsync(
                            URI.create("wss://localhost:" + endpoint.url().port() + "/"), new WebSocket.Listener() {})
                    .get(30, TimeUnit.SECONDS);
            vehicle.sendBinary(ByteBuffer.wrap(new byte[] {1, 2, 3}), true).get(30, TimeUnit.SECONDS);

            TestCloud.await(PATIENCE, () -> gathering.bytes() == 3, () -> "nothing came");
            assertThat(endpoint.url()).asString().startsWith("wssserver://127.0.0.1:");
            try (Socket plain = half(endpoint)) {
                plain.getOutputStream().write("\r\n\r\n".getBytes(StandardCharsets.US_ASCII));
                TestCloud.await(PATIENCE, () -> isClosed(plain), () -> "a plain handshake is waited for");
            }
        }
    }

    /** Shows a certificate that this machine made for itself, and believes it. */
    private static SSLContext certificate(Path directory) throws Exception {
        Path store = directory.resolve("own.p12");
        Process made = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "keytool")
                                .toString(),
                        "-genkeypair",
                        "-alias",
                        "own",
                        "-keyalg",
                        "EC",
                        "-groupname",
                        "secp256r1",
                        "-validity",
                        "30",
                        "-dname",
                        "CN=localhost",
                        "-ext",
                        "san=dns:localhost",
                        "-storetype",
                        "PKCS12",
                        "-keystore",
                        store.toString(),
                        "-storepass",
                        "changeit")
                .redirectErrorStream(true)
                .start();
        assertThat(made.waitFor(60, TimeUnit.SECONDS)).isTrue();
        char[] password = "changeit".toCharArray();
        KeyStore keys = KeyStore.getInstance(store.toFile(), password);
        KeyManagerFactory own = KeyManagerFactory.getInstance(KeyManagerFactory.getDefaultAlgorithm());
        own.init(keys, password);
        KeyStore known = KeyStore.getInstance("PKCS12");
        known.load(null, null);
        known.setCertificateEntry("own", keys.getCertificate("own"));
        TrustManagerFactory trust = TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm());
        trust.init(known);
        SSLContext context = SSLContext.getInstance("TLS");
        context.init(own.getKeyManagers(), trust.getTrustManagers(), null);
        return context;
    }

    @Test
    void doesNotOpenAnEncryptedPortWithoutACertificate() {
        assertThatThrownBy(() -> Endpoint.open(
                        EndpointUrl.parse("wssserver://127.0.0.1:0"),
                        gathering,
                        EndpointSecurity.of(DtlsKeys.none()),
                        new RealTime()))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("no certificate");
    }
}
