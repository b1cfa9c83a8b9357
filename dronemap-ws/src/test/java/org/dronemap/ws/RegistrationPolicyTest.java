package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.http.HttpRequest;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.Map;
import org.dronemap.core.access.Role;
import org.dronemap.ws.testserver.LoopbackAddressClient;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.user.RegistrationPolicy;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** How people whom nobody knows yet come to an account. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class RegistrationPolicyTest {
    private static final String PASSWORD = "a word of my own";

    @TempDir
    private static Path data;

    /** One for each policy, for all tests. */
    private final Map<RegistrationPolicy, TestServer> servers = new EnumMap<>(RegistrationPolicy.class);

    private TestServer house;
    private TestHttpClient administrator;
    private TestHttpClient nobody;
    private LoopbackAddressClient newcomer;

    private void open(RegistrationPolicy registration) {
        house = servers.computeIfAbsent(registration, RegistrationPolicyTest::server);
        administrator = new TestHttpClient(house, house.key(Role.ADMINISTRATOR));
        nobody = new TestHttpClient(house, "");
        newcomer = new LoopbackAddressClient(house);
    }

    private static TestServer server(RegistrationPolicy policy) {
        try {
            return new TestServer(Files.createDirectory(data.resolve(policy.name())), false, policy);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @AfterAll
    void close() {
        servers.values().forEach(TestServer::close);
    }

    @Test
    void letsNobodyInBeforeAnAdministratorDoes() {
        open(RegistrationPolicy.APPROVAL);

        LoopbackAddressClient.Answer asked = register("wanda", null);

        assertThat(asked.status()).isEqualTo(202);
        assertThat(asked.text("state")).isEqualTo("waiting");
        TestHttpClient.Answer early = signIn("wanda");
        assertThat(early.status()).isEqualTo(403);
        assertThat(early.text("detail")).startsWith("Your account waits until an administrator lets you in");
        assertThat(administrator.get("/api/v1/users").raw().body())
                .contains("{\"name\":\"wanda\",\"role\":\"viewer\",\"state\":\"waiting\",\"mustChangePassword\":false,"
                        + "\"onlyGranted\":false}");

        administrator.send(
                "/api/v1/users/wanda",
                request -> request.header("Content-Type", "application/json")
                        .method(
                                "PATCH",
                                HttpRequest.BodyPublishers.ofString("{\"role\":\"operator\",\"state\":\"active\"}")));

        TestHttpClient.Answer session = signIn("wanda");
        assertThat(session.status()).isEqualTo(200);
        assertThat(session.text("role")).isEqualTo("operator");
    }

    @Test
    void letsWhoIsInvitedInAtOnceAndOnlyOnce() {
        open(RegistrationPolicy.INVITATION);
        assertThat(nobody.get("/api/v1/registrations").text("policy")).isEqualTo("invitation");
        assertThat(register("mallory", null).text("detail")).startsWith("Only those who were invited");
        TestHttpClient.Answer invitation = invite("{\"label\":\"Dave of the fire brigade\",\"role\":\"planner\"}");
        assertThat(invitation.status()).isEqualTo(201);
        assertThat(administrator.get("/api/v1/invitations").raw().body())
                .contains("Dave of the fire brigade")
                .doesNotContain(invitation.text("code"));

        LoopbackAddressClient.Answer joined = register("dave", invitation.text("code"));

        assertThat(joined.status()).isEqualTo(201);
        assertThat(signIn("dave").text("role")).isEqualTo("planner");
        LoopbackAddressClient.Answer again = register("eve", invitation.text("code"));
        assertThat(again.status()).isEqualTo(422);
        assertThat(again.text("field")).isEqualTo("invitation");
        assertThat(administrator
                        .get("/api/v1/invitations")
                        .json()
                        .path("invitations")
                        .size())
                .isZero();
    }

    @Test
    void keepsAnInvitationWhenTheNameIsTakenAndTakesItBackWhenWithdrawn() {
        open(RegistrationPolicy.APPROVAL);
        register("carol", null);
        TestHttpClient.Answer invitation = invite("{\"label\":\"Carol\",\"role\":\"viewer\"}");

        LoopbackAddressClient.Answer taken = register("carol", invitation.text("code"));

        assertThat(taken.status()).isEqualTo(409);
        assertThat(taken.text("detail"))
                .isEqualTo("The name carol is taken, or looks like one that is; choose another one.");
        assertThat(administrator
                        .send("/api/v1/invitations/" + invitation.text("id"), HttpRequest.Builder::DELETE)
                        .status())
                .isEqualTo(204);
        assertThat(register("carol2", invitation.text("code")).status()).isEqualTo(422);
    }

    @Test
    void refusesEverybodyWhereItIsOff() {
        open(RegistrationPolicy.OFF);

        assertThat(register("carol", null).text("detail")).startsWith("Accounts are made by the administrators");
        assertThat(nobody.get("/api/v1/registrations").text("policy")).isEqualTo("off");
    }

    @Test
    void slowsDownWhoMakesManyAccounts() {
        open(RegistrationPolicy.APPROVAL);
        for (int i = 0; i < 10; i++) {
            assertThat(register("many-" + i, null).status()).isEqualTo(202);
        }

        LoopbackAddressClient.Answer one = register("many-10", null);

        assertThat(one.status()).isEqualTo(429);
        assertThat(one.text("detail"))
                .matches("Too many registrations from this address; wait \\d+ s and try again\\.");
    }

    @Test
    void letsWhoIsInvitedInWhileOthersFromTheSameAddressHaveToWait() {
        open(RegistrationPolicy.APPROVAL);
        TestHttpClient.Answer invitation = invite("{\"label\":\"Dave\",\"role\":\"viewer\"}");
        for (int i = 0; i < 10; i++) {
            register("others-" + i, null);
        }
        assertThat(register("others-10", "no code of ours").status()).isEqualTo(429);

        assertThat(register("invited-dave", invitation.text("code")).status()).isEqualTo(201);
    }

    @Test
    void slowsDownWhoTriesNamesWithAnInvitation() {
        open(RegistrationPolicy.APPROVAL);
        TestHttpClient.Answer invitation = invite("{\"label\":\"Dave\",\"role\":\"viewer\"}");
        for (int i = 0; i < 10; i++) {
            assertThat(register("a name", invitation.text("code")).status()).isEqualTo(422);
        }

        assertThat(register("dave", invitation.text("code")).text("detail"))
                .startsWith("Too many tries with this invitation");
    }

    @ParameterizedTest
    @ValueSource(strings = {"CAROL", "caro1", "\u0441arol", "\u0441\u0430\u0433ol", "\uff43arol"})
    void takesNoNameThatCannotBeToldFromAnother(String name) {
        open(RegistrationPolicy.APPROVAL);
        register("carol", null);

        assertThat(register(name, null).status()).isIn(409, 422);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "Zo\u00eb",
                "\u0419\u043e\u0433\u0430\u043d",
                "\u7530\u4e2d\u3055\u304f\u3089",
                "anna.maria-2@home"
            })
    void takesNamesOfAnyScript(String name) {
        open(RegistrationPolicy.APPROVAL);

        assertThat(register(name, null).status()).isEqualTo(202);
    }

    @Test
    void namesWhatIsWrong() {
        open(RegistrationPolicy.APPROVAL);

        assertThat(nobody.post("/api/v1/registrations", "{}").text("field")).isEqualTo("name");
        assertThat(nobody.post("/api/v1/registrations", "{\"name\":\"a b\"}").text("field"))
                .isEqualTo("name");
        assertThat(nobody.post("/api/v1/registrations", "{\"name\":\"ab\",\"password\":\"short\"}")
                        .text("field"))
                .isEqualTo("password");
        assertThat(invite("{\"role\":\"viewer\"}").text("field")).isEqualTo("label");
        assertThat(invite("{\"label\":\"x\",\"role\":\"viewer\",\"days\":31}").text("field"))
                .isEqualTo("days");
        assertThat(new TestHttpClient(house, house.key(Role.OPERATOR))
                        .get("/api/v1/invitations")
                        .status())
                .isEqualTo(403);
        assertThat(nobody.get("/api/v1/invitations").status()).isEqualTo(401);
    }

    private TestHttpClient.Answer invite(String body) {
        return administrator.post("/api/v1/invitations", body);
    }

    private LoopbackAddressClient.Answer register(String name, @Nullable String invitation) {
        String code = invitation == null ? "null" : "\"" + invitation + "\"";
        return newcomer.post(
                "/api/v1/registrations",
                "{\"name\":\"" + name + "\",\"password\":\"" + PASSWORD + "\",\"invitation\":" + code + "}");
    }

    private TestHttpClient.Answer signIn(String name) {
        return nobody.post("/api/v1/session", "{\"name\":\"" + name + "\",\"password\":\"" + PASSWORD + "\"}");
    }
}
