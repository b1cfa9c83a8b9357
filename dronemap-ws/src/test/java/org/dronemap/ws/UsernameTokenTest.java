package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.time.Duration;
import java.time.Instant;
import org.dronemap.core.access.Role;
import org.dronemap.ws.testserver.SoapClient;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;

/** UsernameTokens of WS-Security: a password as text, each nonce once and near the time that it was made. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class UsernameTokenTest {
    private static final String SECURITY =
            "http://docs.oasis-open.org/wss/2004/01/oasis-200401-wss-wssecurity-secext-1.0.xsd";
    private static final String MADE =
            "http://docs.oasis-open.org/wss/2004/01/oasis-200401-wss-wssecurity-utility-1.0.xsd";
    private static final String PROFILE =
            "http://docs.oasis-open.org/wss/2004/01/oasis-200401-wss-username-token-profile-1.0#";
    private static final String FIRST = "first password";
    private static final String OWN = "a word of my own";

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestServer house = tenant.server();
    private final String bob = tenant.unique("bob");
    private int nonces;

    @BeforeAll
    void open() {
        SoapClient.withKey(house, tenant.key(Role.ADMINISTRATOR))
                .call("addUser", "name", bob, "role", "operator", "password", FIRST);
        SoapClient.withHeader(house, TestHttpClient.basic(bob, FIRST))
                .call("changePassword", "current", FIRST, "next", OWN);
    }

    private String call(String token) {
        return call(token, "<w:getDronesList/>");
    }

    private String call(String token, String body) {
        String header = "<sec:Security xmlns:sec=\"" + SECURITY + "\" xmlns:made=\"" + MADE
                + "\" s:mustUnderstand=\"1\"><sec:UsernameToken>" + token + "</sec:UsernameToken></sec:Security>";
        return new TestHttpClient(house, "")
                .send(
                        "/services/MAVLinkControllerService",
                        request -> request.header("Content-Type", "text/xml")
                                .POST(HttpRequest.BodyPublishers.ofString(SoapClient.envelope(header, body))))
                .raw()
                .body();
    }

    private String token(String password, String type, String more) {
        return "<sec:Username>" + bob + "</sec:Username><sec:Password Type=\"" + PROFILE + type + "\">" + password
                + "</sec:Password>" + more;
    }

    private String fresh(Instant made) {
        return "<sec:Nonce>" + bob + ++nonces + "</sec:Nonce><made:Created>" + made + "</made:Created>";
    }

    private static void isRefused(String answer, String sentence) {
        assertThat(answer)
                .containsPattern("<faultcode>\\w+:Client</faultcode>")
                .contains("problem:not-signed-in</type>", "<status>401</status>", sentence)
                .doesNotContain(OWN);
    }

    @Test
    void signsInWithThePasswordAsText() {
        assertThat(call(token(OWN, "PasswordText", ""))).contains("getDronesListResponse");
        assertThat(call(token(OWN, "PasswordText", fresh(Instant.now())))).contains("getDronesListResponse");
    }

    @Test
    void refusesAWrongPasswordAsRestDoes() {
        String rest = new TestHttpClient(house, "")
                .post("/api/v1/session", "{\"name\":\"" + bob + "\",\"password\":\"another one\"}")
                .text("detail");

        isRefused(call(token("another one", "PasswordText", "")), rest);
    }

    @Test
    void takesATokenWithANonceOnce() {
        String token = token(OWN, "PasswordText", fresh(Instant.now()));

        assertThat(call(token)).contains("getDronesListResponse");
        isRefused(call(token), "This UsernameToken was used before; make a new nonce for each call.");
    }

    /** What a refused command came to is looked up by the same call. */
    @Test
    void tellsTheOutcomeOfARefusedCommandToATokenWithANonce() {
        String takeOff =
                "<w:takeoff><droneId>" + tenant.vehicle().id() + "</droneId><altitude>10</altitude></w:takeoff>";

        assertThat(call(token(OWN, "PasswordText", fresh(Instant.now())), takeOff))
                .contains("takeoffResponse", "<result>refused</result>");
    }

    @Test
    void takesOnlyTokensThatWereMadeAMomentAgo() {
        Instant now = Instant.now();
        String sentence = "This UsernameToken was made more than 5 minutes from now by the server's clock";

        isRefused(call(token(OWN, "PasswordText", fresh(now.minus(Duration.ofMinutes(6))))), sentence);
        isRefused(call(token(OWN, "PasswordText", fresh(now.plus(Duration.ofMinutes(6))))), sentence);
        isRefused(
                call(token(OWN, "PasswordText", "<made:Created>yesterday</made:Created>")),
                "The Created of a UsernameToken must be a time such as");
        isRefused(
                call(token(OWN, "PasswordText", "<sec:Nonce>a</sec:Nonce>")),
                "A UsernameToken with a Nonce must say when it was Created.");
    }

    @Test
    void refusesADigest() {
        isRefused(
                call(token("YWJj", "PasswordDigest", fresh(Instant.now()))),
                "The Password of a UsernameToken must be sent as #PasswordText");
    }

    @Test
    void refusesATokenWithoutAName() {
        isRefused(call("<sec:Password>" + OWN + "</sec:Password>"), "must have a UsernameToken with a Username");
    }
}
