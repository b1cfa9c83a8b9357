package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.http.HttpRequest;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Who gets the name of somebody who was removed gets nothing else. */
class NamesakeTest {
    private static final String FIRST = "first password";
    private static final String OWN = "a word of my own";
    private static final String VIRTUALS = "/api/v1/virtual-drones";
    /** What people own is not theirs by name. */
    private static final Pattern BY_NAME =
            Pattern.compile("\\.(?:owner|invitedBy|madeBy)\\(\\)\\s*\\.equals\\(\\s*\\w*[pP]rincipal");

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestServer house = tenant.server();
    private final String ann = tenant.unique("ann");
    private TestHttpClient administrator;

    @BeforeEach
    void open() {
        administrator = tenant.http(Role.ADMINISTRATOR);
    }

    /** A new user of that name, with a key. */
    private TestHttpClient joins() {
        TestHttpClient.Answer added = administrator.post(
                "/api/v1/users", "{\"name\":\"" + ann + "\",\"role\":\"operator\",\"password\":\"" + FIRST + "\"}");
        assertThat(added.status()).isEqualTo(201);
        TestHttpClient.Answer session = new TestHttpClient(house, "")
                .post("/api/v1/session", "{\"name\":\"" + ann + "\",\"password\":\"" + FIRST + "\"}");
        String cookie =
                session.raw().headers().firstValue("Set-Cookie").orElseThrow().split(";", 2)[0];
        with(cookie, "/api/v1/session/password", "{\"current\":\"" + FIRST + "\",\"next\":\"" + OWN + "\"}");
        return new TestHttpClient(
                house,
                with(cookie, "/api/v1/access-keys", "{\"label\":\"script\"}").text("key"));
    }

    private TestHttpClient.Answer with(String cookie, String path, String body) {
        return new TestHttpClient(house, "")
                .send(
                        path,
                        request -> request.header("Cookie", cookie)
                                .header("X-Dronemap", "1")
                                .header("Content-Type", "application/json")
                                .method("POST", HttpRequest.BodyPublishers.ofString(body)));
    }

    private static TestHttpClient.Answer delete(TestHttpClient who, String path) {
        return who.send(path, HttpRequest.Builder::DELETE);
    }

    private void leaves() {
        assertThat(delete(administrator, "/api/v1/users/" + ann).status()).isEqualTo(204);
    }

    @Test
    void inheritsNoVirtualDrone() {
        TestHttpClient first = joins();
        String id = first.post(VIRTUALS, "{\"name\":\"Survey\"}").text("id");
        assertThat(first.get(VIRTUALS + "/" + id).status()).isEqualTo(200);
        leaves();
        TestHttpClient second = joins();

        assertThat(second.get(VIRTUALS).json().path("virtualDrones")).isEmpty();
        assertThat(second.get(VIRTUALS + "/" + id).status()).isEqualTo(404);
        assertThat(delete(second, VIRTUALS + "/" + id).status()).isEqualTo(404);
        TestHttpClient.Answer seen = tenant.http(Role.SUPERVISOR).get(VIRTUALS + "/" + id);
        assertThat(seen.text("owner")).isEqualTo(ann);
    }

    @Test
    void isNotTheOneWhoAskedForACommand() {
        String commands = "/api/v1/drones/" + tenant.vehicle().id() + "/commands?wait=10";
        String body = "{\"type\":\"arm\",\"id\":\"" + tenant.unique("same-id") + "\"}";
        assertThat(joins().post(commands, body).status()).isEqualTo(200);
        leaves();

        assertThat(joins().post(commands, body).status()).isEqualTo(409);
    }

    @Test
    void nothingIsSomebodysByName() throws IOException {
        try (Stream<Path> files = Files.walk(Path.of("src/main/java"))) {
            List<Path> byName = files.filter(file -> file.toString().endsWith(".java"))
                    .filter(file -> BY_NAME.matcher(read(file)).find())
                    .toList();
            assertThat(byName).isEmpty();
        }
    }

    private static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
