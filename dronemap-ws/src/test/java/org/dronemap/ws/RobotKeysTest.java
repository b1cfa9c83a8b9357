package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.http.HttpRequest;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.ws.testserver.SharedServer;
import org.dronemap.ws.testserver.SoapClient;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** Keys of robots over HTTP: issued once, kept as hashes, void when replaced or revoked, and each of its organisation. */
class RobotKeysTest {
    private static final String PATH = "/api/v1/robot-keys";

    private static TestServer house;
    private static TestHttpClient administrator;

    @BeforeAll
    static void open() {
        house = SharedServer.get();
        administrator = new TestHttpClient(house, house.key(Role.ADMINISTRATOR));
    }

    private static int delete(TestHttpClient http, String id) {
        return http.send(PATH + "/" + id, HttpRequest.Builder::DELETE).status();
    }

    @Test
    void showsAKeyOnceAndKeepsItsHashOnly() {
        TestHttpClient.Answer made = administrator.post(PATH, "{\"label\":\"Burger\",\"systemId\":7,\"owner\":\"26\"}");
        assertThat(made.status()).isEqualTo(201);
        String key = made.text("key");
        assertThat(key).startsWith("rk-").hasSizeBetween(40, 64);
        assertThat(made.raw().headers().firstValue("Cache-Control")).contains("no-store");

        assertThat(administrator.get(PATH).raw().body())
                .contains("Burger")
                .contains("\"systemId\":7")
                .contains("\"connected\":false")
                .doesNotContain(key);
        assertThat(house.robotKeys().find(key)).hasValueSatisfying(found -> {
            assertThat(found.drone()).isEqualTo(new DroneId(made.text("id")));
            assertThat(found.owner()).isEqualTo("26");
            assertThat(found.hash()).doesNotContain(key);
        });
        assertThat(house.robotKeys().find(key + "x")).isEmpty();
        assertThat(house.records().toString()).doesNotContain(key);
    }

    @Test
    void aKeyThatIsReplacedOrRevokedIsVoidAndItsLinksEnd() {
        TestHttpClient.Answer first = administrator.post(PATH, "{\"label\":\"Turtle\",\"systemId\":8}");
        String id = first.text("id");
        TestHttpClient.Answer second = administrator.post(PATH, "{\"drone\":\"" + id + "\"}");
        assertThat(second.text("id")).isEqualTo(id);
        assertThat(second.text("label")).isEqualTo("Turtle");
        assertThat(house.robotKeys().find(first.text("key"))).isEmpty();
        assertThat(house.robotKeys().find(second.text("key"))).isPresent();

        int ended =
                (int) house.links().disconnected().stream().filter(id::equals).count();
        assertThat(delete(administrator, id)).isEqualTo(204);
        assertThat(house.robotKeys().find(second.text("key"))).isEmpty();
        assertThat(house.links().disconnected().stream().filter(id::equals)).hasSize(ended + 1);
        assertThat(delete(administrator, id)).isEqualTo(404);
    }

    @Test
    void refusesWhatDoesNotFit() {
        for (String body : new String[] {
            "{\"label\":\"x\"}",
            "{\"systemId\":7}",
            "{\"label\":\"x\",\"systemId\":65536}",
            "{\"label\":\"x\",\"systemId\":-1}",
            "{\"label\":\"x\",\"systemId\":7,\"owner\":\"\"}",
            "{\"label\":\"x\",\"systemId\":7,\"organisation\":\"nowhere\"}"
        }) {
            assertThat(administrator.post(PATH, body).status()).as(body).isEqualTo(422);
        }
        assertThat(administrator.post(PATH, "{\"drone\":\"nobody\"}").status()).isEqualTo(404);
        TestHttpClient supervisor = new TestHttpClient(house, house.key(Role.SUPERVISOR));
        assertThat(supervisor.get(PATH).status()).isEqualTo(403);
        assertThat(supervisor.post(PATH, "{\"label\":\"x\",\"systemId\":7}").status())
                .isEqualTo(403);
    }

    @Test
    void areIssuedReplacedListedAndRevokedOverSoapAsWell() {
        SoapClient soap = SoapClient.withKey(house, house.key(Role.ADMINISTRATOR));
        SoapClient.Answer made = soap.call("issueRobotKey", "label", "Of SOAP", "systemId", 9, "owner", "26");
        String id = made.text("id");
        assertThat(house.robotKeys().find(made.text("key"))).hasValueSatisfying(found -> {
            assertThat(found.drone().value()).isEqualTo(id);
            assertThat(found.systemId()).isEqualTo(9);
            assertThat(found.owner()).isEqualTo("26");
        });
        assertThat(soap.call("listRobotKeys").texts("robotKeys.item.id")).containsOnlyOnce(id);
        assertThat(soap.call("listRobotKeys").texts("robotKeys.item.key")).isEmpty();

        SoapClient.Answer newer = soap.call("issueRobotKey", "drone", id);
        assertThat(newer.text("label")).isEqualTo("Of SOAP");
        assertThat(house.robotKeys().find(made.text("key"))).isEmpty();
        soap.call("revokeRobotKey", "robotKeyId", id);
        assertThat(house.robotKeys().find(newer.text("key"))).isEmpty();
        assertThat(administrator.get(PATH).raw().body()).doesNotContain(id);
        assertThat(house.records().toString()).doesNotContain(made.text("key")).doesNotContain(newer.text("key"));

        assertThatThrownBy(() -> soap.call("revokeRobotKey", "robotKeyId", id)).isInstanceOf(SoapClient.Refused.class);
        assertThatThrownBy(() -> soap.call("issueRobotKey", "label", "x", "systemId", 65_536))
                .isInstanceOf(SoapClient.Refused.class)
                .hasMessageContaining("65535");
        SoapClient supervisor = SoapClient.withKey(house, house.key(Role.SUPERVISOR));
        assertThatThrownBy(() -> supervisor.call("listRobotKeys")).isInstanceOf(SoapClient.Refused.class);
    }

    @Test
    void aRobotBelongsToTheOrganisationOfItsKeyBeforeItEverCalledIn() {
        String organisation = administrator
                .post("/api/v1/organisations", "{\"name\":\"Mountain rescue " + house.number() + "\"}")
                .text("id");
        OrganisationId theirs = new OrganisationId(organisation);
        TestHttpClient root =
                house.member(theirs, "their-root", Role.ADMINISTRATOR).http();

        String own = root.post(PATH, "{\"label\":\"Rescuer\",\"systemId\":7}").text("id");
        String given = administrator
                .post(PATH, "{\"label\":\"Gift\",\"systemId\":8,\"organisation\":\"" + organisation + "\"}")
                .text("id");

        assertThat(house.grants().owner(new DroneId(own))).isEqualTo(theirs);
        assertThat(house.grants().owner(new DroneId(given))).isEqualTo(theirs);
        assertThat(root.get(PATH).raw().body()).contains(own).contains(given);
        assertThat(administrator.get(PATH).raw().body()).doesNotContain(own);
        assertThat(delete(administrator, own)).isEqualTo(404);
        assertThat(root.post(PATH, "{\"label\":\"x\",\"systemId\":7,\"organisation\":\"home\"}")
                        .status())
                .isEqualTo(403);
    }
}
