package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.util.HexFormat;
import org.dronemap.core.access.Role;
import org.dronemap.ws.testserver.FakeVehicleLinkGateway;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.SharedServer;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** Endpoints, keys of vehicles and metrics over HTTP. */
class LinksTest {
    private static TestServer house;
    private static TestHttpClient administrator;

    @BeforeAll
    static void open() {
        house = SharedServer.get();
        administrator = new TestHttpClient(house, house.key(Role.ADMINISTRATOR));
    }

    private static TestHttpClient.Answer delete(TestHttpClient http, String path) {
        return http.send(path, HttpRequest.Builder::DELETE);
    }

    @Test
    void addsListsAndRemovesAnEndpoint() {
        TestHttpClient.Answer added =
                administrator.post("/api/v1/endpoints", "{\"url\":\"tcpserver://127.0.0.1:5999\"}");
        assertThat(added.status()).isEqualTo(201);
        assertThat(added.text("origin")).isEqualTo("added");
        assertThat(added.text("addedBy")).startsWith("user");
        String path = "/api/v1/endpoints/" + added.text("id");
        assertThat(administrator.get(path).text("url")).isEqualTo("tcpserver://127.0.0.1:5999");
        assertThat(administrator
                        .get(path)
                        .json()
                        .path("counts")
                        .path("kernelDrops")
                        .asInt())
                .isEqualTo(11);

        assertThat(delete(administrator, path).status()).isEqualTo(204);
        assertThat(administrator.get(path).status()).isEqualTo(404);
    }

    @Test
    void theServerIsNotUpBeforeVehiclesAreLetIn() {
        house.connected(false);
        TestHttpClient.Answer early = administrator.get("/api/v1/health");
        house.connected(true);

        assertThat(early.text("links")).isEqualTo("down");
        assertThat(early.text("status")).isEqualTo("degraded");
        assertThat(administrator.get("/api/v1/health").text("status")).isEqualTo("up");
    }

    @Test
    void listsAnEndpointThatCannotOpenWithTheReason() {
        TestHttpClient.Answer added =
                administrator.post("/api/v1/endpoints", "{\"url\":\"serial:///dev/none?baud=57600\"}");

        assertThat(added.status()).isEqualTo(201);
        assertThat(added.text("state")).isEqualTo("failed");
        assertThat(added.text("reason")).isEqualTo("there is no device");
        assertThat(delete(administrator, "/api/v1/endpoints/" + added.text("id"))
                        .status())
                .isEqualTo(204);
    }

    @Test
    void refusesWhatIsNoUrlAndWhatIsThereAlready() {
        TestHttpClient.Answer wrong = administrator.post("/api/v1/endpoints", "{\"url\":\"here\"}");
        assertThat(wrong.status()).isEqualTo(422);
        assertThat(wrong.text("field")).isEqualTo("url");
        assertThat(administrator.post("/api/v1/endpoints", "{}").status()).isEqualTo(422);
        assertThat(administrator
                        .post("/api/v1/endpoints", "{\"url\":\"" + FakeVehicleLinkGateway.CONFIGURED + "\"}")
                        .status())
                .isEqualTo(409);
        TestHttpClient.Answer configured = delete(administrator, "/api/v1/endpoints/configured-1");
        assertThat(configured.status()).isEqualTo(409);
        assertThat(configured.text("detail")).contains("DRONEMAP_ENDPOINTS");
    }

    @Test
    void isForAdministratorsOnly() {
        TestHttpClient operator = new TestHttpClient(house, house.key(Role.OPERATOR));

        assertThat(operator.get("/api/v1/endpoints").status()).isEqualTo(403);
        assertThat(operator.get("/api/v1/traffic").status()).isEqualTo(403);
        assertThat(operator.get("/api/v1/dtls-keys").status()).isEqualTo(403);
        assertThat(operator.post("/api/v1/endpoints", "{\"url\":\"udpserver://127.0.0.1:1\"}")
                        .status())
                .isEqualTo(403);
        assertThat(operator.post("/api/v1/dtls-keys", "{\"label\":\"x\"}").status())
                .isEqualTo(403);
        assertThat(delete(operator, "/api/v1/endpoints/configured-1").status()).isEqualTo(403);
    }

    @Test
    void showsTheSecretOfANewKeyOnceAndEndsItsLinksWhenItIsRevoked() {
        TestHttpClient.Answer made = administrator.post("/api/v1/dtls-keys", "{\"label\":\"Survey copter\"}");
        assertThat(made.status()).isEqualTo(201);
        String identity = made.text("identity");
        assertThat(HexFormat.of().parseHex(made.text("secret"))).hasSize(32);

        TestHttpClient.Answer listed = administrator.get("/api/v1/dtls-keys");
        assertThat(listed.raw().body())
                .contains(identity)
                .contains("Survey copter")
                .doesNotContain(made.text("secret"));

        assertThat(delete(administrator, "/api/v1/dtls-keys/" + identity).status())
                .isEqualTo(204);
        assertThat(delete(administrator, "/api/v1/dtls-keys/" + identity).status())
                .isEqualTo(404);
        assertThat(house.links().disconnected()).contains(identity);
    }

    @Test
    void makesTheKeyOfAKnownDroneUnderItsOwnId() {
        String drone =
                ScriptedVehicle.connect(house.cloud(), 20_000 + house.number()).id();

        TestHttpClient.Answer made = administrator.post("/api/v1/dtls-keys", "{\"drone\":\"" + drone + "\"}");

        assertThat(made.text("identity")).isEqualTo(drone);
        assertThat(made.text("label")).isNotEmpty();
        assertThat(administrator
                        .post("/api/v1/dtls-keys", "{\"drone\":\"nobody\"}")
                        .status())
                .isEqualTo(404);
    }

    @Test
    void givesMetricsToAnyKeyButToNobodyWithoutOne() {
        TestHttpClient viewer = new TestHttpClient(house, house.key(Role.VIEWER));

        // The outlet of the house takes each who has a passphrase for one who is attached, also those of other tests.
        double before = attached(viewer.get("/metrics"));
        assertThat(viewer.send(
                                "/api/v1/outlet/passphrase",
                                request -> request.header("Content-Type", "application/json")
                                        .PUT(HttpRequest.BodyPublishers.ofString("{}")))
                        .status())
                .isEqualTo(200);

        TestHttpClient.Answer metrics = viewer.get("/metrics");

        assertThat(metrics.status()).isEqualTo(200);
        assertThat(metrics.raw().headers().firstValue("Content-Type").orElse(""))
                .startsWith("text/plain");
        assertThat(metrics.raw().body())
                .contains("dronemap_endpoint_frames_in_total{endpoint=\"configured-1\",url=\""
                        + FakeVehicleLinkGateway.CONFIGURED + "\"} 2.0")
                .contains("dronemap_endpoint_kernel_drops_total")
                .contains("dronemap_vehicle_received_total{drone=\"drone-1\",session=\"127.0.0.1:14601:1\"")
                .contains("dronemap_drones{state=\"live\"}")
                .contains("dronemap_robot_refused_total{why=\"notBelieved\"} 4.0")
                .contains("dronemap_outlet_refused_total{why=\"badSignature\"} ")
                .contains("jvm_memory_heap_used_bytes");
        assertThat(attached(metrics)).isEqualTo(before + 1);
        for (String path : new String[] {"/metrics", "/metrics/", "/metrics;x=1", "//metrics"}) {
            assertThat(new TestHttpClient(house, "").get(path).raw().body()).doesNotContain("dronemap_endpoint");
        }
        assertThat(new TestHttpClient(house, "").get("/metrics").status()).isEqualTo(401);
    }

    private static double attached(TestHttpClient.Answer metrics) {
        return metrics.raw()
                .body()
                .lines()
                .filter(line -> line.startsWith("dronemap_outlet_clients "))
                .mapToDouble(line -> Double.parseDouble(line.substring(line.indexOf(' ') + 1)))
                .findFirst()
                .orElseThrow();
    }
}
