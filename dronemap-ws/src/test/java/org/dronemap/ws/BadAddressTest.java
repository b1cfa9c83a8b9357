package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import org.dronemap.core.access.Role;
import org.dronemap.ws.testserver.SharedServer;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Addresses that lead nowhere, or are none, are answered with a problem as everything else is. */
class BadAddressTest {
    private static TestServer house;

    @BeforeAll
    static void open() {
        house = SharedServer.get();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"/services/NoSuchService", "/services/", "/services", "/services/MAVLinkControllerService/deeper"
            })
    void answersAnUnknownAddressOfServicesWithAProblem(String address) {
        TestHttpClient.Answer answer = new TestHttpClient(house, house.key(Role.VIEWER)).get(address);

        assertThat(answer.status()).isEqualTo(404);
        assertThat(answer.raw().headers().firstValue("Content-Type")).hasValue("application/problem+json");
        assertThat(answer.text("detail"))
                .contains("/services/MAVLinkControllerService?wsdl", "/services/FollowerService?wsdl");
    }

    @ParameterizedTest
    @ValueSource(strings = {"/api/v1/%zz", "/api/v1/drones/%", "/%zz", "/services/%zz", "/api/v1/a\\b"})
    void answersABrokenAddressWithAProblem(String target) throws IOException {
        String answer = answerTo(target);

        assertThat(answer)
                .startsWith("HTTP/1.1 400")
                .containsIgnoringCase("content-type: application/problem+json")
                .contains("urn:dronemap:problem:malformed", "\"status\":400")
                .doesNotContain("<html", "Tomcat");
    }

    @ParameterizedTest
    @ValueSource(strings = {"?=x", "?active=%zz", "?active=false&=x"})
    void saysWhatIsWrongWithAQueryThatCannotBeRead(String query) throws IOException {
        String answer = answerTo("/api/v1/drones" + query, "Authorization: Bearer " + house.key(Role.VIEWER) + "\r\n");

        assertThat(answer).startsWith("HTTP/1.1 400").contains("NAME=VALUE", "\"code\":\"request-unreadable\"");
    }

    @Test
    void takesACookieOfItsNameThatIsNotItsOwn() throws IOException {
        String answer = answerTo("/api/v1/session/oidc/callback", "Cookie: dronemap-oidc=%m<TqE9\r\n");

        assertThat(answer).startsWith("HTTP/1.1 404");
    }

    private static String answerTo(String target) throws IOException {
        return answerTo(target, "");
    }

    /** A client of the library would not send such an address. */
    private static String answerTo(String target, String headers) throws IOException {
        try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), house.httpPort())) {
            socket.setSoTimeout(30_000);
            String request =
                    "GET " + target + " HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n" + headers + "\r\n";
            socket.getOutputStream().write(request.getBytes(StandardCharsets.US_ASCII));
            return new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        }
    }
}
