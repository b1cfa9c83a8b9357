package org.dronemap.ws.plainhttp;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.cert.CertificateFactory;
import java.util.List;
import org.dronemap.ws.testserver.SelfSignedCertificate;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;

/** What can be had without TLS: the authority's certificate, and words. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class PhoneTrustServerTest {
    @TempDir
    private static Path folder;

    private final HttpClient client = HttpClient.newHttpClient();
    private PhoneTrustServer.Configuration place;
    private PhoneTrustServer door;

    @BeforeAll
    void open() throws IOException {
        SelfSignedCertificate.make(folder);
        Path certificate = folder.resolve("certificate.pem");
        place = new PhoneTrustServer.Configuration("127.0.0.1", 0, certificate, certificate, 8443);
        door = PhoneTrustServer.open(place);
    }

    @AfterAll
    void close() {
        door.close();
    }

    private HttpResponse<byte[]> send(String method, String path) throws IOException, InterruptedException {
        HttpRequest request = HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + door.port() + path))
                .method(method, HttpRequest.BodyPublishers.noBody())
                .build();
        return client.send(request, HttpResponse.BodyHandlers.ofByteArray());
    }

    @Test
    void handsOutTheCertificateAndItsFingerprint() throws Exception {
        HttpResponse<byte[]> answer = send("GET", "/dronemap-authority.crt");

        assertThat(answer.headers().firstValue("Content-Type")).hasValue("application/x-x509-ca-cert");
        assertThat(CertificateFactory.getInstance("X.509").generateCertificate(new ByteArrayInputStream(answer.body())))
                .isEqualTo(LocalCertificateAuthority.read(place.authority(), place.certificate())
                        .certificate());
        assertThat(new String(send("GET", "/").body(), StandardCharsets.UTF_8))
                .contains(LocalCertificateAuthority.read(place.authority(), place.certificate())
                        .fingerprint())
                .contains("https://localhost:8443/follow")
                .doesNotContain("{here}", "{page}", "{code", "{fingerprint}");
    }

    @Test
    void knowsNothingElseAndRunsNothing() throws Exception {
        HttpResponse<byte[]> answer = send("GET", "/api/v1/health");

        assertThat(new String(answer.body(), StandardCharsets.UTF_8))
                .contains("Download the certificate")
                .doesNotContain("uptime");
        assertThat(answer.headers().firstValue("Content-Security-Policy").orElse(""))
                .contains("default-src 'none'");
        assertThat(send("POST", "/api/v1/session").statusCode()).isEqualTo(405);
        assertThat(send("HEAD", "/").body()).isEmpty();
    }

    @Test
    void sendsPhonesToANameThatTheyCanReach() throws IOException {
        LocalCertificateAuthority made = LocalCertificateAuthority.read(place.authority(), place.certificate());
        LocalCertificateAuthority authority = new LocalCertificateAuthority(
                made.certificate(), made.fingerprint(), List.of("localhost", "127.0.0.1", "192.168.1.7", "drones.lan"));

        assertThat(authority.name()).isEqualTo("192.168.1.7");
        assertThat(authority.nameFor("Drones.lan")).isEqualTo("drones.lan");
        assertThat(authority.nameFor("localhost")).isEqualTo("192.168.1.7");
        assertThat(authority.nameFor("evil.example\"><script>")).isEqualTo("192.168.1.7");
    }

    @Test
    void failsWhereThereIsNoCertificate() throws IOException {
        Path broken = Files.writeString(folder.resolve("broken.pem"), "no certificate");

        assertThatThrownBy(() ->
                        PhoneTrustServer.open(new PhoneTrustServer.Configuration("127.0.0.1", 0, broken, broken, 8443)))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("broken.pem");
    }
}
