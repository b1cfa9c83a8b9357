package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import org.dronemap.core.access.Role;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class LinkSecurityTest {
    private static final String GIVEN = "0123456789abcdef0123456789ABCDEF0123456789abcdef0123456789abcdef";

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestServer house = tenant.server();
    private TestHttpClient administrator;
    private String drone;

    @BeforeEach
    void open() {
        drone = "/api/v1/drones/" + tenant.vehicle().id();
        administrator = tenant.http(Role.ADMINISTRATOR);
    }

    private static TestHttpClient.Answer put(TestHttpClient http, String path, String body) {
        return http.send(
                path,
                builder -> builder.header("Content-Type", "application/json")
                        .PUT(HttpRequest.BodyPublishers.ofString(body)));
    }

    @Test
    void everybodyMayLookAtCountsAndPolicy() {
        TestHttpClient.Answer answer = tenant.http(Role.VIEWER).get(drone + "/link-security");

        assertThat(answer.status()).isEqualTo(200);
        assertThat(answer.text("policy")).isEqualTo("off");
        assertThat(answer.json().path("key").isNull()).isTrue();
        assertThat(answer.json().path("messages").path("badSignature").asInt()).isEqualTo(3);
    }

    @Test
    void onlyAnAdministratorTouchesKeysAndPolicy() {
        TestHttpClient operator = tenant.http(Role.OPERATOR);

        assertThat(operator.post(drone + "/link-key", "{}").status()).isEqualTo(403);
        assertThat(operator.post(drone + "/link-key/install", "{}").status()).isEqualTo(403);
        assertThat(operator.post(drone + "/link-key/rotate", "{}").status()).isEqualTo(403);
        assertThat(operator.send(drone + "/link-key", HttpRequest.Builder::DELETE)
                        .status())
                .isEqualTo(403);
        assertThat(put(operator, drone + "/link-security", "{\"policy\":\"off\"}")
                        .status())
                .isEqualTo(403);
    }

    @Test
    void aMadeKeyIsShownOnce() {
        TestHttpClient.Answer made = administrator.post(drone + "/link-key", "{}");

        assertThat(made.status()).isEqualTo(201);
        assertThat(made.text("key")).matches("[0-9a-f]{64}");
        assertThat(made.raw().headers().firstValue("Cache-Control")).contains("no-store");
        TestHttpClient.Answer later = administrator.get(drone + "/link-security");
        assertThat(later.json().path("key").path("fingerprint").asString()).isEqualTo(made.text("fingerprint"));
        assertThat(later.raw().body()).doesNotContain(made.text("key"));
        TestHttpClient.Answer again = administrator.post(drone + "/link-key", "{}");
        assertThat(again.status()).isEqualTo(409);
        assertThat(again.text("code")).isEqualTo("link-key-in-use");
    }

    @Test
    void aKeyCanBeBroughtAlong() {
        assertThat(administrator
                        .post(drone + "/link-key", "{\"key\":\"" + GIVEN + "\"}")
                        .text("key"))
                .isEqualToIgnoringCase(GIVEN);
    }

    @Test
    void aBadKeyIsRefusedWithoutRepeatingIt() {
        for (String bad : new String[] {"abc123secret", "0".repeat(64), GIVEN + "0"}) {
            TestHttpClient.Answer answer = administrator.post(drone + "/link-key", "{\"key\":\"" + bad + "\"}");
            assertThat(answer.status()).isEqualTo(422);
            assertThat(answer.text("field")).isEqualTo("key");
            assertThat(answer.raw().body()).doesNotContain(bad);
        }
    }

    @Test
    void aChangeThatFailsSaysWhyAndAConfirmedOneGoesOn() {
        administrator.post(drone + "/link-key", "{}");
        TestHttpClient.Answer refused = administrator.post(drone + "/link-key/rotate", "{}");
        assertThat(refused.status()).isEqualTo(409);
        assertThat(refused.text("detail")).contains("could be listened to");
        assertThat(refused.text("code")).isEqualTo("link-not-safe");

        assertThat(administrator
                        .post(drone + "/link-key/rotate", "{\"confirm\":true}")
                        .status())
                .isEqualTo(200);
    }

    @Test
    void thePolicyIsOneOfThree() {
        assertThat(put(administrator, drone + "/link-security", "{\"policy\":\"required\"}")
                        .text("policy"))
                .isEqualTo("required");
        TestHttpClient.Answer wrong = put(administrator, drone + "/link-security", "{\"policy\":\"sometimes\"}");
        assertThat(wrong.status()).isEqualTo(422);
        assertThat(wrong.text("allowed")).isEqualTo("off, optional or required");
        assertThat(put(administrator, drone + "/link-security", "{}").status()).isEqualTo(422);
    }

    @Test
    void aKeyCanBeForgottenHereOnly() {
        administrator.post(drone + "/link-key", "{}");
        TestHttpClient.Answer gone = administrator.send(drone + "/link-key?vehicle=false", HttpRequest.Builder::DELETE);

        assertThat(gone.status()).isEqualTo(200);
        assertThat(gone.json().path("key").isNull()).isTrue();
    }

    @Test
    void anUnknownDroneHasNoLink() {
        assertThat(administrator.get("/api/v1/drones/nobody/link-security").status())
                .isEqualTo(404);
        assertThat(administrator.post("/api/v1/drones/nobody/link-key", "{}").status())
                .isEqualTo(404);
    }
}
