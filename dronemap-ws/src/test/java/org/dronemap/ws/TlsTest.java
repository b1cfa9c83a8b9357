package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.WebSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.cert.X509Certificate;
import java.time.Duration;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import javax.net.ssl.SSLSocket;
import org.awaitility.Awaitility;
import org.dronemap.core.access.Role;
import org.dronemap.ws.settings.ServerSettings;
import org.dronemap.ws.testserver.RawClient;
import org.dronemap.ws.testserver.SelfSignedCertificate;
import org.dronemap.ws.testserver.ServerLog;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.user.RegistrationPolicy;
import org.dronemap.ws.wiring.StreamPort;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;

/** With a certificate, page, interfaces and stream speak TLS and nothing else, and a renewed one is used without a restart. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class TlsTest {
    private static final Duration PATIENCE = Duration.ofSeconds(60);

    @TempDir
    private static Path data;

    private SelfSignedCertificate certificate;
    private TestServer house;
    private String key;

    @BeforeAll
    void open() throws IOException {
        Path tls = Files.createDirectory(data.resolve("tls"));
        certificate = SelfSignedCertificate.make(tls);
        house = new TestServer(
                data,
                new TestServer.Options(
                        false,
                        RegistrationPolicy.APPROVAL,
                        ServerSettings.Protection.DEFAULT,
                        SelfSignedCertificate.files(tls),
                        null));
        key = house.key(Role.VIEWER);
    }

    @AfterAll
    void close() {
        house.close();
    }

    private HttpResponse<String> get(String path) throws Exception {
        HttpRequest request = HttpRequest.newBuilder(URI.create("https://localhost:" + house.httpPort() + path))
                .header("Authorization", "Bearer " + key)
                .build();
        return HttpClient.newBuilder()
                .sslContext(certificate.trust())
                .build()
                .send(request, HttpResponse.BodyHandlers.ofString());
    }

    private int streamPort() {
        return house.bean(StreamPort.class).number();
    }

    @Test
    void serves() throws Exception {
        HttpResponse<String> answer = get("/api/v1/drones");

        assertThat(answer.statusCode()).isEqualTo(200);
        assertThat(answer.headers().firstValue("Strict-Transport-Security")).hasValue("max-age=15552000");
        assertThat(answer.headers().firstValue("Content-Security-Policy").orElse(""))
                .contains("wss://localhost:" + streamPort())
                .doesNotContain("unsafe");
        LinkedBlockingQueue<String> heard = new LinkedBlockingQueue<>();
        WebSocket stream = HttpClient.newBuilder()
                .sslContext(certificate.trust())
                .build()
                .newWebSocketBuilder()
                .header("Authorization", "Bearer " + key)
                .buildAsync(URI.create("wss://localhost:" + streamPort() + "/stream"), new WebSocket.Listener() {
                    @Override
                    public CompletionStage<?> onText(WebSocket socket, CharSequence text, boolean last) {
                        heard.add(text.toString());
                        return WebSocket.Listener.super.onText(socket, text, last);
                    }
                })
                .get(30, TimeUnit.SECONDS);
        assertThat(heard.poll(30, TimeUnit.SECONDS)).contains("hello");
        stream.abort();
    }

    @Test
    void marksTheSessionForEncryptedConnectionsOnly() throws Exception {
        String password =
                Files.readString(data.resolve("first-password.txt")).strip().split(" ", 2)[1];
        HttpRequest request = HttpRequest.newBuilder(
                        URI.create("https://localhost:" + house.httpPort() + "/api/v1/session"))
                .header("Content-Type", "application/json")
                .POST(HttpRequest.BodyPublishers.ofString("{\"name\":\"admin\",\"password\":\"" + password + "\"}"))
                .build();
        HttpResponse<String> answer = HttpClient.newBuilder()
                .sslContext(certificate.trust())
                .build()
                .send(request, HttpResponse.BodyHandlers.ofString());

        assertThat(answer.headers().firstValue("Set-Cookie").orElse(""))
                .contains("Secure", "HttpOnly", "SameSite=Strict");
    }

    @Test
    void tellsNothingToWhoDoesNotEncrypt() {
        for (int port : new int[] {house.httpPort(), streamPort()}) {
            try (RawClient plain = new RawClient(port)) {
                plain.say("GET /api/v1/health HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
                assertThat(plain.hearAll()).doesNotContain("HTTP/1.1 200", "uptime");
            }
        }
    }

    @Test
    void usesARenewedCertificateWithoutARestart() throws Exception {
        X509Certificate before = shown(house.httpPort());
        assertThat(before).isEqualTo(certificate.certificate());
        certificate = SelfSignedCertificate.make(data.resolve("tls"));

        for (int port : new int[] {house.httpPort(), streamPort()}) {
            Awaitility.await("port " + port)
                    .atMost(PATIENCE)
                    .pollInterval(Duration.ofMillis(300))
                    .until(() -> shown(port).equals(certificate.certificate()));
        }
        assertThat(get("/api/v1/drones").statusCode()).isEqualTo(200);
    }

    /** Trusts whatever is there, to look at it. */
    private static X509Certificate shown(int port) throws IOException {
        try (SSLSocket socket =
                (SSLSocket) Everybody.context().getSocketFactory().createSocket("127.0.0.1", port)) {
            socket.setSoTimeout(30_000);
            socket.startHandshake();
            return (X509Certificate) socket.getSession().getPeerCertificates()[0];
        }
    }

    @Test
    void keepsTheCertificateWhenTheNewFilesAreBroken() throws Exception {
        Files.writeString(data.resolve("tls").resolve("key.pem"), "this is no key");

        try (ServerLog log = new ServerLog()) {
            // It is looked at while somebody comes.
            Awaitility.await("it has been looked at")
                    .atMost(PATIENCE)
                    .pollInterval(Duration.ofMillis(300))
                    .until(() -> {
                        assertThat(shown(streamPort())).isEqualTo(certificate.certificate());
                        return log.has("The former one stays in use.");
                    });
        }
        assertThat(shown(streamPort())).isEqualTo(certificate.certificate());
        assertThat(get("/api/v1/drones").statusCode()).isEqualTo(200);
    }

    /** A client that believes everybody. */
    private static final class Everybody implements javax.net.ssl.X509TrustManager {
        static javax.net.ssl.SSLContext context() {
            try {
                javax.net.ssl.SSLContext context = javax.net.ssl.SSLContext.getInstance("TLS");
                context.init(null, new javax.net.ssl.TrustManager[] {new Everybody()}, null);
                return context;
            } catch (java.security.GeneralSecurityException e) {
                throw new IllegalStateException(e);
            }
        }

        @Override
        public void checkClientTrusted(X509Certificate[] chain, String type) {
            // only looked at
        }

        @Override
        public void checkServerTrusted(X509Certificate[] chain, String type) {
            // only looked at
        }

        @Override
        public X509Certificate[] getAcceptedIssuers() {
            return new X509Certificate[0];
        }
    }
}
