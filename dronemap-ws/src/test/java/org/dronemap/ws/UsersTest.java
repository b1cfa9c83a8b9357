package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.http.HttpRequest;
import java.util.List;
import java.util.Map;
import org.dronemap.core.access.Role;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.SoapClient;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What administrators do with users, and that it takes effect at once. */
class UsersTest {
    private static final String FIRST = "first password";
    private static final String OWN = "a word of my own";

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestServer house = tenant.server();
    private final String bob = tenant.unique("bob");
    private TestHttpClient administrator;
    private TestHttpClient nobody;

    @BeforeEach
    void open() {
        administrator = tenant.http(Role.ADMINISTRATOR);
        nobody = new TestHttpClient(house, "");
    }

    @Test
    void letsANewUserDoNothingBeforeThePasswordIsTheirOwn() {
        add(bob, "operator");
        String cookie = cookie(signIn(bob, FIRST));

        TestHttpClient.Answer closed = with(cookie, "GET", "/api/v1/drones", "");

        assertThat(closed.status()).isEqualTo(403);
        assertThat(closed.text("detail")).startsWith("Somebody else has seen your password");
        assertThatThrownBy(() -> SoapClient.withHeader(house, TestHttpClient.basic(bob, FIRST))
                        .call("getDronesList"))
                .hasMessageStartingWith("Somebody else has seen your password");
        assertThat(takeOwnPassword(cookie).status()).isEqualTo(204);
        assertThat(with(cookie, "GET", "/api/v1/drones", "").status()).isEqualTo(200);
    }

    @Test
    void shutsADisabledUserOutOfEveryFaceAtOnceAndLetsThemInAgain() {
        String cookie = join(bob, "operator");
        String key = with(cookie, "POST", "/api/v1/access-keys", "{\"label\":\"script\"}")
                .text("key");
        try (RecordingStreamClient byKey = RecordingStreamClient.withKey(house, key);
                RecordingStreamClient byTicket = ticketed(cookie)) {
            byKey.await(message -> message.path("type").asString().equals("drones"));
            byTicket.await(message -> message.path("type").asString().equals("drones"));

            assertThat(change(bob, "{\"state\":\"disabled\"}").text("state")).isEqualTo("disabled");

            assertThat(byKey.awaitClose()).startsWith("This session has ended");
            assertThat(byTicket.awaitClose()).startsWith("This session has ended");
        }
        assertThat(with(cookie, "GET", "/api/v1/drones", "").status()).isEqualTo(401);
        assertThat(new TestHttpClient(house, key).get("/api/v1/drones").status())
                .isEqualTo(401);
        assertThatThrownBy(() -> SoapClient.withKey(house, key).call("getDronesList"))
                .hasMessageContaining("not valid");
        TestHttpClient.Answer again = signIn(bob, OWN);
        assertThat(again.status()).isEqualTo(403);
        assertThat(again.text("detail")).isEqualTo("Your account has been disabled; ask an administrator.");
        assertThat(signIn(bob, "a wrong password").status()).isEqualTo(401);

        change(bob, "{\"state\":\"active\"}");

        assertThat(signIn(bob, OWN).status()).isEqualTo(200);
        assertThat(new TestHttpClient(house, key).get("/api/v1/drones").status())
                .isEqualTo(200);
    }

    @Test
    void givesAChangedRoleToSessionsKeysAndOpenStreamsAtOnce() {
        String cookie = join(bob, "administrator");
        String key = with(cookie, "POST", "/api/v1/access-keys", "{\"label\":\"script\"}")
                .text("key");
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, key)) {
            stream.await(message -> message.path("type").asString().equals("drones"));

            change(bob, "{\"role\":\"viewer\"}");

            assertThat(stream.awaitClose()).isEqualTo("Your role was changed; connect again.");
        }
        assertThat(new TestHttpClient(house, key).get("/api/v1/users").status()).isEqualTo(403);
        assertThat(with(cookie, "GET", "/api/v1/session", "").text("role")).isEqualTo("viewer");
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, key)) {
            assertThat(stream.await(message -> message.path("type").asString().equals("hello"))
                            .path("role")
                            .asString())
                    .isEqualTo("viewer");
        }
    }

    @Test
    void endsSessionsAndTheirStreamsWhenAPasswordIsReset() {
        String cookie = join(bob, "operator");
        try (RecordingStreamClient stream = ticketed(cookie)) {
            stream.await(message -> message.path("type").asString().equals("drones"));

            TestHttpClient.Answer reset = administrator.post("/api/v1/users/" + bob + "/password", "");

            assertThat(stream.awaitClose()).startsWith("This session has ended");
            assertThat(signIn(bob, OWN).status()).isEqualTo(401);
            assertThat(signIn(bob, reset.text("password"))
                            .json()
                            .path("mustChangePassword")
                            .asBoolean())
                    .isTrue();
        }
    }

    @Test
    void signsOutEverywhereByTheUserOrAnAdministratorAndKeepsKeys() {
        String one = join(bob, "operator");
        String other = cookie(signIn(bob, OWN));
        String key = with(one, "POST", "/api/v1/access-keys", "{\"label\":\"script\"}")
                .text("key");
        try (RecordingStreamClient stream = ticketed(other)) {
            stream.await(message -> message.path("type").asString().equals("drones"));

            assertThat(with(one, "POST", "/api/v1/session/sign-out-everywhere", "")
                            .status())
                    .isEqualTo(204);

            assertThat(stream.awaitClose()).startsWith("This session has ended");
        }
        assertThat(with(one, "GET", "/api/v1/session", "").status()).isEqualTo(401);
        assertThat(with(other, "GET", "/api/v1/session", "").status()).isEqualTo(401);
        String third = cookie(signIn(bob, OWN));
        assertThat(administrator.post("/api/v1/users/" + bob + "/sign-out", "").status())
                .isEqualTo(204);
        assertThat(with(third, "GET", "/api/v1/session", "").status()).isEqualTo(401);
        assertThat(new TestHttpClient(house, key).get("/api/v1/drones").status())
                .isEqualTo(200);
    }

    @Test
    void silencesAStreamWhoseKeyIsRemoved() {
        String cookie = join(bob, "operator");
        TestHttpClient.Answer made = with(cookie, "POST", "/api/v1/access-keys", "{\"label\":\"script\"}");
        try (RecordingStreamClient byKey = RecordingStreamClient.withKey(house, made.text("key"));
                RecordingStreamClient byTicket = ticketed(cookie)) {
            byKey.await(message -> message.path("type").asString().equals("drones"));
            byTicket.await(message -> message.path("type").asString().equals("drones"));

            with(cookie, "DELETE", "/api/v1/access-keys/" + made.text("id"), "");

            assertThat(byKey.awaitClose()).startsWith("This session has ended");
            byTicket.send("{\"type\":\"ping\"}");
            byTicket.await(message -> message.path("type").asString().equals("pong"));
        }
    }

    @Test
    void letsAnAdministratorSeeAndRemoveTheKeysOfAUser() {
        String cookie = join(bob, "operator");
        TestHttpClient.Answer made = with(cookie, "POST", "/api/v1/access-keys", "{\"label\":\"script\"}");
        String path = "/api/v1/users/" + bob + "/access-keys";

        String listed = administrator.get(path).raw().body();
        assertThat(listed).contains("\"label\":\"script\"").doesNotContain(made.text("key"));
        assertThat(tenant.http(Role.SUPERVISOR).get(path).status()).isEqualTo(403);
        assertThat(administrator
                        .send(path + "/" + made.text("id"), HttpRequest.Builder::DELETE)
                        .status())
                .isEqualTo(204);

        assertThat(new TestHttpClient(house, made.text("key"))
                        .get("/api/v1/drones")
                        .status())
                .isEqualTo(401);
        assertThat(administrator
                        .send(path + "/" + made.text("id"), HttpRequest.Builder::DELETE)
                        .status())
                .isEqualTo(404);
        assertThat(administrator.get("/api/v1/users/carol/access-keys").status())
                .isEqualTo(404);
    }

    @Test
    void showsReportersNoDroneThroughAnyFace() {
        String key = tenant.key(Role.REPORTER);
        String sentence = "Your role may send reports, not see drones; ask an administrator for the viewer role.";

        assertThat(new TestHttpClient(house, key).get("/api/v1/drones").text("detail"))
                .isEqualTo(sentence);
        assertThatThrownBy(() -> SoapClient.withKey(house, key).call("getDronesList"))
                .hasMessage(sentence);
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, key)) {
            assertThat(stream.awaitClose()).isEqualTo(sentence);
            assertThat(stream.heard())
                    .noneMatch(message -> message.path("type").asString().equals("drones"));
        }
    }

    @Test
    void refusesWhatWouldLeaveNobodyToManageTheServer() {
        String root = tenant.unique("root");
        String own = join(root, "administrator");

        TestHttpClient.Answer answer = with(own, "PATCH", "/api/v1/users/" + root, "{\"role\":\"viewer\"}");

        assertThat(answer.status()).isEqualTo(409);
        assertThat(answer.text("detail")).isEqualTo("You cannot do this to yourself; ask another administrator.");
        assertThat(with(own, "PATCH", "/api/v1/users/" + root, "{\"state\":\"disabled\"}")
                        .status())
                .isEqualTo(409);
        assertThat(with(own, "DELETE", "/api/v1/users/" + root, "").status()).isEqualTo(409);
    }

    @Test
    void namesWhatIsWrongWithAChange() {
        add(bob, "operator");

        assertThat(change(bob, "{}").text("field")).isEqualTo("role");
        assertThat(change(bob, "{\"role\":\"king\"}").text("detail"))
                .contains("administrator, supervisor, operator, planner, viewer or reporter");
        assertThat(change(bob, "{\"state\":\"waiting\"}").text("detail")).contains("active or disabled");
        assertThat(change("carol", "{\"state\":\"active\"}").status()).isEqualTo(404);
        assertThat(administrator.post("/api/v1/users/carol/password", "").status())
                .isEqualTo(404);
        assertThat(tenant.http(Role.SUPERVISOR).get("/api/v1/users").text("detail"))
                .isEqualTo("Only an administrator may do this; you are signed in as supervisor.");
    }

    @Test
    void slowsDownWhoGuessesThePresentPasswordAsAtTheSignIn() {
        String cookie = join(bob, "operator");
        String wrong = "{\"current\":\"a guess\",\"next\":\"another password\"}";
        for (int guess = 0; guess < 5; guess++) {
            assertThat(with(cookie, "POST", "/api/v1/session/password", wrong).status())
                    .isEqualTo(422);
        }

        assertThat(with(cookie, "POST", "/api/v1/session/password", wrong).status())
                .isEqualTo(429);
        assertThat(signIn(bob, OWN).status()).isEqualTo(429);
    }

    @Test
    void aLimitedKeyTouchesNoAccount() {
        String cookie = join(bob, "operator");
        for (String limits : List.of("\"role\":\"viewer\"", "\"operations\":[\"view\"]")) {
            String key = with(cookie, "POST", "/api/v1/access-keys", "{\"label\":\"script\"," + limits + "}")
                    .text("key");
            TestHttpClient limited = new TestHttpClient(house, key);

            TestHttpClient.Answer changed = limited.post(
                    "/api/v1/session/password", "{\"current\":\"" + OWN + "\",\"next\":\"another password\"}");
            assertThat(changed.status()).isEqualTo(403);
            assertThat(changed.text("detail")).startsWith("A limited access key changes no password");
            assertThat(limited.post("/api/v1/session/sign-out-everywhere", "").status())
                    .isEqualTo(403);
        }
        assertThat(signIn(bob, OWN).status()).isEqualTo(200);
    }

    /** A user with a password of their own; the answer is a session's cookie. */
    private String join(String name, String role) {
        add(name, role);
        String cookie = cookie(signIn(name, FIRST));
        takeOwnPassword(cookie);
        return cookie;
    }

    private void add(String name, String role) {
        TestHttpClient.Answer added = administrator.post(
                "/api/v1/users",
                "{\"name\":\"" + name + "\",\"role\":\"" + role + "\",\"password\":\"" + FIRST + "\"}");
        assertThat(added.status()).isEqualTo(201);
    }

    private TestHttpClient.Answer takeOwnPassword(String cookie) {
        return with(
                cookie, "POST", "/api/v1/session/password", "{\"current\":\"" + FIRST + "\",\"next\":\"" + OWN + "\"}");
    }

    private TestHttpClient.Answer change(String name, String body) {
        return administrator.send(
                "/api/v1/users/" + name,
                request -> request.header("Content-Type", "application/json")
                        .method("PATCH", HttpRequest.BodyPublishers.ofString(body)));
    }

    private TestHttpClient.Answer signIn(String name, String password) {
        return nobody.post("/api/v1/session", "{\"name\":\"" + name + "\",\"password\":\"" + password + "\"}");
    }

    private TestHttpClient.Answer with(String cookie, String method, String path, String body) {
        return nobody.send(
                path,
                request -> request.header("Cookie", cookie)
                        .header("X-Dronemap", "1")
                        .header("Content-Type", "application/json")
                        .method(method, HttpRequest.BodyPublishers.ofString(body)));
    }

    private RecordingStreamClient ticketed(String cookie) {
        String ticket = with(cookie, "POST", "/api/v1/stream-tickets", "").text("ticket");
        return RecordingStreamClient.with(house, "?ticket=" + ticket, Map.of());
    }

    private static String cookie(TestHttpClient.Answer session) {
        return session.raw().headers().firstValue("Set-Cookie").orElse("").split(";", 2)[0];
    }
}
