package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.http.HttpRequest;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** XML made to eat memory and time, or to read what it must not, is refused quickly by every address that reads XML. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class HostileXmlTest {
    private static final String CANARY = "canary-of-a-file-that-no-answer-shows";
    private static final Duration QUICKLY = Duration.ofSeconds(20);

    @TempDir
    private static Path data;

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestServer house = tenant.server();
    private TestHttpClient supervisor;

    @BeforeAll
    void open() {
        supervisor = tenant.http(Role.SUPERVISOR);
    }

    private static String soap(String inside) {
        return "<s:Envelope xmlns:s=\"http://schemas.xmlsoap.org/soap/envelope/\""
                + " xmlns:w=\"http://cloud.dronemap.org/wsdl\"><s:Body>" + inside + "</s:Body></s:Envelope>";
    }

    private static String kml(String inside) {
        return "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Placemark>" + inside + "</Placemark></kml>";
    }

    private static String laughs() {
        return "<!DOCTYPE x [<!ENTITY a0 \"ha\">"
                + IntStream.range(1, 30)
                        .mapToObj(n -> "<!ENTITY a" + n + " \"&a" + (n - 1) + ";&a" + (n - 1) + ";\">")
                        .collect(Collectors.joining())
                + "]>";
    }

    /** What makes XML hostile, as documents around and inside of a call or a file of zones. */
    static Stream<Arguments> hostile() {
        String many =
                IntStream.range(0, 9_000).mapToObj(n -> " a" + n + "=\"1\"").collect(Collectors.joining());
        String spaces = IntStream.range(0, 9_000)
                .mapToObj(n -> " xmlns:n" + n + "=\"u\"")
                .collect(Collectors.joining());
        return Stream.of(
                Arguments.of("entities in entities", laughs(), "<name>&a29;</name>"),
                Arguments.of(
                        "one long entity, often",
                        "<!DOCTYPE x [<!ENTITY a \"" + "a".repeat(50_000) + "\">]>",
                        "<name>" + "&a;".repeat(50_000) + "</name>"),
                Arguments.of("a file", "<!DOCTYPE x [<!ENTITY a SYSTEM \"file:FILE\">]>", "<name>&a;</name>"),
                Arguments.of(
                        "another server",
                        "<!DOCTYPE x [<!ENTITY a SYSTEM \"http://127.0.0.1:PORT/\">]>",
                        "<name>&a;</name>"),
                Arguments.of(
                        "a description from another server",
                        "<!DOCTYPE x SYSTEM \"http://127.0.0.1:PORT/\">",
                        "<name>a</name>"),
                Arguments.of(
                        "entities of parameters",
                        "<!DOCTYPE x [<!ENTITY % a SYSTEM \"http://127.0.0.1:PORT/\"> %a;]>",
                        "<name>a</name>"),
                Arguments.of("depth", "", "<a>".repeat(40_000) + "</a>".repeat(40_000)),
                Arguments.of("depth without end", "", "<a>".repeat(200_000)),
                Arguments.of("elements", "", "<a/>".repeat(200_000)),
                Arguments.of("attributes", "", "<a" + many + "/>"),
                Arguments.of("namespaces", "", "<a" + spaces + "/>"),
                Arguments.of("a long attribute", "", "<a b=\"" + "b".repeat(900_000) + "\"/>"),
                Arguments.of("a long name", "", "<" + "a".repeat(900_000) + "/>"),
                Arguments.of("a long text", "", "<name>" + "a".repeat(900_000) + "</name>"),
                Arguments.of("a long comment", "", "<!--" + "a".repeat(900_000) + "--><name"),
                Arguments.of(
                        "an instruction to another server",
                        "<?xml-stylesheet href=\"http://127.0.0.1:PORT/\"?>",
                        "<a/>"));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("hostile")
    void isRefusedInSoapWithAFaultOfTheCaller(String what, String before, String inside) throws IOException {
        try (ServerSocket other = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            TestHttpClient.Answer answer = send(
                    "/services/MAVLinkControllerService",
                    "text/xml",
                    filled(before, other) + soap("<w:getDrone><droneId>" + inside + "</droneId></w:getDrone>"));

            assertThat(answer.status()).isEqualTo(500);
            assertThat(answer.raw().body()).containsPattern("<faultcode>\\w+:Client</faultcode>");
            refusedQuietly(answer, other);
        }
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("hostile")
    void isRefusedInAFileOfZones(String what, String before, String inside) throws IOException {
        try (ServerSocket other = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            TestHttpClient.Answer answer = send(
                    "/api/v1/zones/import",
                    "application/vnd.google-earth.kml+xml",
                    filled(before, other) + kml(inside));

            assertThat(answer.status()).isBetween(400, 422);
            refusedQuietly(answer, other);
        }
    }

    @Test
    void doesNotFallForAnotherEncoding() {
        for (Charset charset :
                new Charset[] {StandardCharsets.UTF_16, StandardCharsets.UTF_16LE, Charset.forName("UTF-32")}) {
            String document = "<?xml version=\"1.0\" encoding=\"" + charset.name() + "\"?>" + laughs()
                    + soap("<w:getDronesList/>");
            TestHttpClient.Answer answer = supervisor.send(
                    "/services/MAVLinkControllerService",
                    request -> request.header("Content-Type", "text/xml")
                            .timeout(QUICKLY)
                            .POST(HttpRequest.BodyPublishers.ofByteArray(document.getBytes(charset))));

            assertThat(answer.raw().body())
                    .contains("faultcode")
                    .doesNotContain("getDronesListResponse", "Exception", "\tat ");
        }
    }

    @Test
    void boundsWhatStandsInTheHeaderOfAMessageToo() {
        String message = "<s:Envelope xmlns:s=\"http://schemas.xmlsoap.org/soap/envelope/\"><s:Header>"
                + "<a>".repeat(40_000) + "</a>".repeat(40_000) + "</s:Header><s:Body/></s:Envelope>";

        TestHttpClient.Answer answer = send("/services/MAVLinkControllerService", "text/xml", message);

        assertThat(answer.raw().body())
                .containsPattern("<faultcode>\\w+:Client</faultcode>")
                .doesNotContain("Exception");
    }

    /** Each bound of docs/security.md, in a header that nobody reads: nothing else is in the way there. */
    static Stream<Arguments> bounds() {
        return Stream.of(
                Arguments.of("depth", "<a>".repeat(20) + "</a>".repeat(20), "<a>".repeat(40) + "</a>".repeat(40)),
                Arguments.of("elements", group("<b/>", 4, 4_000), group("<b/>", 6, 4_000)),
                Arguments.of("attributes", "<a" + attributes(40) + "/>", "<a" + attributes(60) + "/>"));
    }

    private static String group(String element, int groups, int each) {
        return ("<a>" + element.repeat(each) + "</a>").repeat(groups);
    }

    private static String attributes(int count) {
        return IntStream.range(0, count).mapToObj(n -> " a" + n + "=\"1\"").collect(Collectors.joining());
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("bounds")
    void keepsToEachBoundThatItStates(String what, String within, String beyond) {
        assertThat(send("/services/MAVLinkControllerService", "text/xml", withHeader(within))
                        .raw()
                        .body())
                .contains("getDronesListResponse");
        assertThat(send("/services/MAVLinkControllerService", "text/xml", withHeader(beyond))
                        .raw()
                        .body())
                .containsPattern("<faultcode>\\w+:Client</faultcode>");
    }

    private static String withHeader(String header) {
        return soap("<w:getDronesList/>").replace("<s:Body>", "<s:Header><h>" + header + "</h></s:Header><s:Body>");
    }

    @Test
    void repeatsNoLongNameOfAnOperation() {
        TestHttpClient.Answer answer =
                send("/services/MAVLinkControllerService", "text/xml", soap("<w:" + "a".repeat(900_000) + "/>"));

        assertThat(answer.raw().body()).contains("faultcode").hasSizeLessThan(5_000);
    }

    private static String filled(String text, ServerSocket other) throws IOException {
        Path file = Files.writeString(data.resolve("secret-file"), CANARY);
        return text.replace("FILE", file.toString()).replace("PORT", String.valueOf(other.getLocalPort()));
    }

    private TestHttpClient.Answer send(String path, String type, String document) {
        return supervisor.send(
                path,
                request -> request.header("Content-Type", type)
                        .timeout(QUICKLY)
                        .POST(HttpRequest.BodyPublishers.ofString(document)));
    }

    private void refusedQuietly(TestHttpClient.Answer answer, ServerSocket other) throws IOException {
        assertThat(answer.raw().body()).doesNotContain(CANARY, "Exception", "\tat ", "org.apache", "com.ctc", "java.");
        assertThat(answer.raw().body().length()).isLessThan(5_000);
        other.setSoTimeout(50);
        assertThat(org.assertj.core.api.Assertions.catchThrowable(other::accept))
                .as("nobody asks another server")
                .isInstanceOf(java.net.SocketTimeoutException.class);
        assertThat(supervisor.get("/api/v1/drones").status()).isEqualTo(200);
    }
}
