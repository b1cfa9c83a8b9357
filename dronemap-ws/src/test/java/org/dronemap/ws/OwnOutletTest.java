package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.time.Duration;
import java.time.Instant;
import java.util.Set;
import org.dronemap.core.access.KeyRights;
import org.dronemap.core.access.KeyScope;
import org.dronemap.core.access.Permission;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.ws.testserver.SharedServer;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** One's own passphrase for the outlet. */
class OwnOutletTest {
    private static final String PATH = "/api/v1/outlet/passphrase";
    private static final String PORTS = "/api/v1/outlet/ports";

    private static TestServer house;

    @BeforeAll
    static void open() {
        house = SharedServer.get();
    }

    private static TestHttpClient.Answer set(TestHttpClient who, String body) {
        return who.send(
                PATH,
                request -> request.header("Content-Type", "application/json")
                        .PUT(HttpRequest.BodyPublishers.ofString(body)));
    }

    @Test
    void isMadeUpAndShownOnce() {
        TestHttpClient ann = new TestHttpClient(house, house.key(Role.VIEWER));
        assertThat(ann.get("/api/v1/outlet").json().path("passphraseSet").asBoolean(true))
                .isFalse();
        TestHttpClient.Answer answer = set(ann, "{}");
        assertThat(answer.status()).isEqualTo(200);
        assertThat(answer.raw().headers().firstValue("Cache-Control")).hasValue("no-store");
        assertThat(answer.json().path("passphrase").asString("")).hasSizeGreaterThan(16);
        TestHttpClient.Answer own = ann.get("/api/v1/outlet");
        assertThat(own.json().path("passphraseSet").asBoolean(false)).isTrue();
        assertThat(own.raw().body())
                .doesNotContain(answer.json().path("passphrase").asString(""));
    }

    @Test
    void isLongEnoughAndNobodyElses() {
        TestHttpClient ann = new TestHttpClient(house, house.key(Role.VIEWER));
        for (String bad : new String[] {"fifteen letters", " sixteen letters", "sixteen letters\\u00e4"}) {
            TestHttpClient.Answer answer = set(ann, "{\"passphrase\":\"" + bad + "\"}");
            assertThat(answer.status()).isEqualTo(422);
            assertThat(answer.json().path("field").asString("")).isEqualTo("passphrase");
        }
        String good = "{\"passphrase\":\"sixteen letters!\"}";
        assertThat(set(ann, good).status()).isEqualTo(200);
        assertThat(set(ann, good).status()).isEqualTo(200);
        assertThat(set(new TestHttpClient(house, house.key(Role.VIEWER)), good).status())
                .isEqualTo(409);
    }

    @Test
    void isNotSetByAKeyThatMayLessThanItsUserOrEnds() {
        KeyScope looking = new KeyScope(null, Set.of(Permission.VIEW));
        KeyScope one = new KeyScope(Set.of(new DroneId("drone-1")), Set.of(Permission.values()));
        for (KeyRights rights : new KeyRights[] {
            new KeyRights(Role.OPERATOR, looking, null),
            new KeyRights(Role.OPERATOR, one, null),
            new KeyRights(Role.OPERATOR, KeyScope.ALL, Instant.parse("2100-01-01T00:00:00Z"))
        }) {
            assertThat(set(new TestHttpClient(house, house.key(OrganisationId.HOME, rights)), "{}")
                            .status())
                    .isEqualTo(403);
        }
        assertThat(set(new TestHttpClient(house, house.key(Role.OPERATOR)), "{}")
                        .status())
                .isEqualTo(200);
    }

    private static TestHttpClient.Answer open(TestHttpClient who, String body) {
        return who.post(PORTS, body);
    }

    private static TestHttpClient.Answer close(TestHttpClient who, String id) {
        return who.send(PORTS + "/" + id, HttpRequest.Builder::DELETE);
    }

    @Test
    void aPersonalPortIsOfItsUserAloneAndClosedByAdministratorsToo() {
        TestHttpClient ann = new TestHttpClient(house, house.key(Role.VIEWER));
        TestHttpClient bob = new TestHttpClient(house, house.key(Role.OPERATOR));
        TestHttpClient.Answer answer = open(ann, "{\"address\":\"192.0.2.77/24\",\"hours\":2}");
        assertThat(answer.status()).isEqualTo(201);
        assertThat(answer.json().path("address").asString("")).isEqualTo("192.0.2.0/24");
        Instant since = Instant.parse(answer.json().path("since").asString(""));
        assertThat(answer.json().path("until").asString(""))
                .isEqualTo(since.plus(Duration.ofHours(2)).toString());
        String id = answer.json().path("id").asString("");
        assertThat(ann.get("/api/v1/outlet").json().path("ports").findValuesAsString("id"))
                .containsExactly(id);
        assertThat(bob.get("/api/v1/outlet").json().path("ports").size()).isZero();
        assertThat(close(bob, id).status()).isEqualTo(404);
        assertThat(close(ann, id).status()).isEqualTo(204);
        assertThat(close(ann, id).status()).isEqualTo(404);
        String second =
                open(ann, "{\"address\":\"192.0.2.7\"}").json().path("id").asString("");
        assertThat(close(new TestHttpClient(house, house.key(Role.ADMINISTRATOR)), second)
                        .status())
                .isEqualTo(204);
    }

    @Test
    void aPersonalPortWantsASmallRangeAndAFewHours() {
        TestHttpClient ann = new TestHttpClient(house, house.key(Role.VIEWER));
        for (String address : new String[] {"", "localhost", "192.0.0.0/16", "0.0.0.0/0"}) {
            TestHttpClient.Answer answer = open(ann, "{\"address\":\"" + address + "\"}");
            assertThat(answer.status()).isEqualTo(422);
            assertThat(answer.json().path("field").asString("")).isEqualTo("address");
        }
        assertThat(open(ann, "{}").status()).isEqualTo(422);
        TestHttpClient.Answer long25 = open(ann, "{\"address\":\"192.0.2.7\",\"hours\":25}");
        assertThat(long25.status()).isEqualTo(422);
        assertThat(long25.json().path("field").asString("")).isEqualTo("hours");
        KeyScope one = new KeyScope(Set.of(new DroneId("drone-1")), Set.of(Permission.values()));
        TestHttpClient bounded =
                new TestHttpClient(house, house.key(OrganisationId.HOME, new KeyRights(Role.OPERATOR, one, null)));
        assertThat(open(bounded, "{\"address\":\"192.0.2.7\"}").status()).isEqualTo(403);
    }
}
