package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.http.HttpRequest;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.function.UnaryOperator;
import org.dronemap.core.access.Role;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.SharedServer;
import org.dronemap.ws.testserver.SoapClient;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class AccessTest {
    private static final String PASSWORD = "0123456789";
    private static final String NEXT = "a better password";

    private TestServer house = SharedServer.get();
    private TestHttpClient nobody = new TestHttpClient(house, "");

    @Test
    void makesTheFirstAdministratorWithAPasswordOnlyTheOwnerCanRead() throws IOException {
        Path file = house.data().resolve("first-password.txt");

        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file)))
                .isEqualTo("rw-------");
        assertThat(Files.readString(file)).matches("admin [a-z0-9-]{20,}\n");
        TestHttpClient.Answer session = signIn(firstPassword());
        assertThat(session.status()).isEqualTo(200);
        assertThat(session.json().path("mustChangePassword").asBoolean()).isTrue();
        assertThat(session.raw().headers().firstValue("Set-Cookie").orElse(""))
                .contains("HttpOnly", "SameSite=Strict", "Max-Age=43200");
    }

    @Test
    void wantsTenCharacters() throws IOException {
        TestHttpClient.Answer answer = change(cookie(signIn(firstPassword())), firstPassword(), "short");

        assertThat(answer.status()).isEqualTo(422);
        assertThat(answer.text("field")).isEqualTo("next");
        assertThat(answer.text("detail")).isEqualTo("A password must have 10 to 200 characters; this one has 5.");
    }

    @Test
    void wantsAHeaderThatOtherSitesCannotSend() throws IOException {
        String cookie = cookie(signIn(firstPassword()));

        TestHttpClient.Answer without = nobody.send(
                "/api/v1/session", request -> request.header("Cookie", cookie).DELETE());
        TestHttpClient.Answer with = nobody.send(
                "/api/v1/session",
                request -> request.header("Cookie", cookie)
                        .header("X-Dronemap", "1")
                        .DELETE());

        assertThat(without.status()).isEqualTo(403);
        assertThat(with.status()).isEqualTo(204);
        TestHttpClient.Answer after = session(cookie);
        assertThat(after.status()).isEqualTo(401);
        assertThat(after.text("type")).isEqualTo("urn:dronemap:problem:session-ended");
        assertThat(after.text("detail")).startsWith("This session has ended");
    }

    @Test
    void makesGuessersWait() throws IOException {
        try (TestTenant tenant = new TestTenant()) {
            String bob = user(tenant);
            for (int attempt = 0; attempt < 5; attempt++) {
                assertThat(signIn(bob, "wrong").status()).isEqualTo(401);
            }

            TestHttpClient.Answer sixth = signIn(bob, PASSWORD);

            assertThat(sixth.status()).isEqualTo(429);
            assertThat(sixth.text("detail")).matches("Too many wrong passwords; wait \\d+ s and try again\\.");
        } finally {
            // What was wrong from this address is forgotten once somebody is right.
            assertThat(signIn(firstPassword()).status()).isEqualTo(200);
        }
    }

    /** Who can sign in with a password. */
    private static String user(TestTenant tenant) {
        String name = tenant.unique("bob");
        TestHttpClient.Answer made = tenant.http(Role.ADMINISTRATOR)
                .post(
                        "/api/v1/users",
                        "{\"name\":\"" + name + "\",\"role\":\"operator\",\"password\":\"" + PASSWORD + "\"}");
        assertThat(made.status()).isEqualTo(201);
        return name;
    }

    @Test
    void letsTheOwnerOfTheMachineMakeKeysThatDoNoMoreThanTheySay() throws IOException {
        TestHttpClient owner = new TestHttpClient(
                house, Files.readString(house.data().resolve("local-key")).strip());

        TestHttpClient.Answer made = owner.post("/api/v1/access-keys", "{\"label\":\"a viewer\",\"role\":\"viewer\"}");
        TestHttpClient viewer = new TestHttpClient(house, made.text("key"));

        assertThat(made.status()).isEqualTo(201);
        assertThat(viewer.get("/api/v1/drones").status()).isEqualTo(200);
        assertThat(viewer.get("/api/v1/users").status()).isEqualTo(403);
        assertThat(viewer.post("/api/v1/access-keys", "{\"label\":\"more\",\"role\":\"administrator\"}")
                        .status())
                .isEqualTo(403);
        assertThat(owner.get("/api/v1/access-keys").raw().body()).doesNotContain(made.text("key"));
        assertThat(owner.send("/api/v1/access-keys/" + made.text("id"), HttpRequest.Builder::DELETE)
                        .status())
                .isEqualTo(204);
        assertThat(viewer.get("/api/v1/drones").status()).isEqualTo(401);
    }

    @Test
    void takesAKeyAwayWithItsOwner() {
        try (TestTenant tenant = new TestTenant()) {
            String name = user(tenant);
            TestHttpClient.Answer bob = signIn(name, PASSWORD);
            assertThat(bob.text("role")).isEqualTo("operator");

            tenant.http(Role.ADMINISTRATOR).send("/api/v1/users/" + name, HttpRequest.Builder::DELETE);

            assertThat(session(cookie(bob)).status()).isEqualTo(401);
        }
    }

    @Test
    void signsInToSoapByNameAndPassword() throws IOException {
        String basic = TestHttpClient.basic("admin", firstPassword());
        List<String> seen = new TestHttpClient(house, house.key(Role.VIEWER))
                .get("/api/v1/drones")
                .json()
                .path("drones")
                .findValuesAsString("id");

        SoapClient.Answer listed = SoapClient.withHeader(house, basic).call("getDronesList");

        assertThat(listed.texts("drones.item.id")).containsExactlyInAnyOrderElementsOf(seen);
    }

    @Test
    void staysClosedToTheNetworkWithTheFirstPasswordAndOpensWhenItIsChanged(@TempDir Path data) throws IOException {
        try (TestServer open = new TestServer(data, true)) {
            house = open;
            nobody = new TestHttpClient(open, "");
            String sentence = "This server is open to the network and still has its first administrator password;"
                    + " sign in as admin and change it, then everything works.";
            String first = firstPassword();
            String one = cookie(signIn(first));
            String other = cookie(signIn(first));
            String key = open.key(Role.OPERATOR);

            assertThat(new TestHttpClient(open, key).get("/api/v1/drones").text("detail"))
                    .isEqualTo(sentence);
            assertThatThrownBy(() -> SoapClient.withKey(open, key).call("getDronesList"))
                    .hasMessage(sentence);
            try (RecordingStreamClient stream = RecordingStreamClient.withKey(open, key)) {
                assertThat(stream.awaitClose()).startsWith("This server is open to the network");
            }
            assertThat(change(one, first, NEXT).status()).isEqualTo(204);
            assertThat(data.resolve("first-password.txt")).doesNotExist();
            assertThat(session(one).json().path("mustChangePassword").asBoolean())
                    .isFalse();
            assertThat(session(other).status()).isEqualTo(401);
            assertThat(signIn(NEXT).status()).isEqualTo(200);
            assertThat(new TestHttpClient(open, key).get("/api/v1/drones").status())
                    .isEqualTo(200);
        }
    }

    private String firstPassword() throws IOException {
        return Files.readString(house.data().resolve("first-password.txt"))
                .strip()
                .split(" ", 2)[1];
    }

    private TestHttpClient.Answer signIn(String password) {
        return signIn("admin", password);
    }

    private TestHttpClient.Answer signIn(String name, String password) {
        return nobody.post("/api/v1/session", "{\"name\":\"" + name + "\",\"password\":\"" + password + "\"}");
    }

    private TestHttpClient.Answer session(String cookie) {
        return nobody.send(
                "/api/v1/session", request -> request.header("Cookie", cookie).GET());
    }

    private TestHttpClient.Answer change(String cookie, String current, String next) {
        UnaryOperator<HttpRequest.Builder> how = request -> request.header("Cookie", cookie)
                .header("X-Dronemap", "1")
                .header("Content-Type", "application/json")
                .POST(HttpRequest.BodyPublishers.ofString(
                        "{\"current\":\"" + current + "\",\"next\":\"" + next + "\"}"));
        return nobody.send("/api/v1/session/password", how);
    }

    private static String cookie(TestHttpClient.Answer session) {
        return session.raw().headers().firstValue("Set-Cookie").orElse("").split(";", 2)[0];
    }
}
