package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.ws.budget.BudgetRates;
import org.dronemap.ws.budget.WorkKind;
import org.dronemap.ws.limit.ClientLimits;
import org.dronemap.ws.settings.ServerSettings;
import org.dronemap.ws.testserver.ConditionWait;
import org.dronemap.ws.testserver.RawClient;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.ServerLog;
import org.dronemap.ws.testserver.SharedServer;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.JsonNode;

/** Too much of anything, from strangers or from users, is refused quickly and in words; the service goes on. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class FloodTest {
    private static final int TEN_MEGABYTES = 10_000_000;
    /** Ten of each at once, then so few that no machine refills the budget while a test runs. */
    private static final BudgetRates FEW =
            new BudgetRates(Map.of(WorkKind.REQUEST, 10.0, WorkKind.COMMAND, 1.0, WorkKind.EXPORT, 0.2));

    private final TestServer house = SharedServer.get();
    private TestServer thrifty;
    private ScriptedVehicle vehicle;

    @BeforeAll
    void open(@TempDir Path data) {
        thrifty = new TestServer(
                data, TestServer.Options.protectedBy(new ServerSettings.Protection(ClientLimits.DEFAULT, FEW, 2)));
        vehicle = ScriptedVehicle.connect(thrifty.cloud(), 15_701);
    }

    @AfterAll
    void close() {
        thrifty.close();
    }

    static Stream<Arguments> takers() {
        return Stream.of(
                Arguments.of("/api/v1/session", "application/json"),
                Arguments.of("/api/v1/registrations", "application/json"),
                Arguments.of("/api/v1/missions", "application/json"),
                Arguments.of("/api/v1/missions", "application/x-www-form-urlencoded"),
                Arguments.of("/api/v1/missions", "multipart/form-data; boundary=x"),
                Arguments.of("/api/v1/zones/import", "application/vnd.google-earth.kml+xml"),
                Arguments.of("/services/MAVLinkControllerService", "text/xml"),
                Arguments.of("/services/MAVLinkControllerService", "multipart/related; boundary=x"));
    }

    @ParameterizedTest(name = "{0} {1}")
    @MethodSource("takers")
    void refusesTenMegabytesBeforeTheyAreSent(String path, String type) {
        try (RawClient client = new RawClient(house.httpPort())) {
            client.say(head(path, type) + "Content-Length: " + TEN_MEGABYTES + "\r\n\r\n");

            assertThat(client.hearLine()).startsWith("HTTP/1.1 413");
        }
    }

    @Test
    void turnsAwayWhoseRoleIsTooLowBeforeTheBodyIsSent() {
        try (RawClient client = new RawClient(house.httpPort())) {
            client.say(head("/api/v1/users", "application/json") + "Content-Length: 1000\r\n\r\n");

            assertThat(client.hearLine()).startsWith("HTTP/1.1 403");
        }
    }

    @ParameterizedTest(name = "{0} {1}")
    @MethodSource("takers")
    void refusesTenMegabytesThatWereNotAnnounced(String path, String type) {
        try (RawClient client = new RawClient(house.httpPort());
                ServerLog log = new ServerLog()) {
            // Nothing is wrong with it but its length.
            sayWithoutLength(client, path, type, type.contains("json") ? "{\"name\":\"" : "<a>", "a".repeat(10_000));

            // What no address takes is refused unread, and a message of SOAP by a fault.
            boolean read = type.contains("json") || type.contains("kml");
            assertThat(client.hearLine())
                    .matches(
                            read
                                    ? "HTTP/1.1 413.*"
                                    : path.startsWith("/services")
                                            ? "|HTTP/1.1 (4\\d\\d|500).*"
                                            : "|HTTP/1.1 4\\d\\d.*");
            assertThat(log.failures()).isEmpty();
        }
        assertThat(new TestHttpClient(house, house.key(Role.VIEWER))
                        .get("/api/v1/drones")
                        .status())
                .isEqualTo(200);
    }

    @Test
    void saysInAFaultThatAMessageOfSoapIsTooLongWhoseLengthWasNotAnnounced() {
        try (RawClient client = new RawClient(house.httpPort());
                ServerLog log = new ServerLog()) {
            sayWithoutLength(
                    client,
                    "/services/MAVLinkControllerService",
                    "text/xml",
                    "<s:Envelope xmlns:s=\"http://schemas.xmlsoap.org/soap/envelope/\"><s:Header>",
                    // No element of it is too long.
                    "<n>" + "a".repeat(9_993) + "</n>");

            assertThat(client.hearAll())
                    .startsWith("HTTP/1.1 500")
                    .contains("The body of this request may have at most 1 MB.")
                    .containsPattern("<faultcode>\\w+:Client</faultcode>");
            assertThat(log.failures()).isEmpty();
        }
    }

    /** Ten megabytes, or as much as the server wants of them. */
    private void sayWithoutLength(RawClient client, String path, String type, String beginning, String piece) {
        client.say(head(path, type) + "Connection: close\r\nTransfer-Encoding: chunked\r\n\r\n");
        client.say(Integer.toHexString(beginning.length()) + "\r\n" + beginning + "\r\n");
        String chunk = Integer.toHexString(piece.length()) + "\r\n" + piece + "\r\n";
        int said = 0;
        while (said < TEN_MEGABYTES && client.say(chunk)) {
            said += piece.length();
        }
        client.say("0\r\n\r\n");
    }

    private String head(String path, String type) {
        return "POST " + path + " HTTP/1.1\r\nHost: localhost\r\nAuthorization: Bearer " + house.key(Role.SUPERVISOR)
                + "\r\nContent-Type: " + type + "\r\n";
    }

    @Test
    void closesAStreamThatSendsTenMegabytesAtOnce() {
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, house.key(Role.VIEWER))) {
            stream.await(message -> message.path("type").asString().equals("drones"));
            stream.send("x".repeat(TEN_MEGABYTES));

            assertThat(stream.awaitClose()).isNotNull();
        }
    }

    @Test
    void refusesAThousandTriesToSignInWithoutTryingThemAll() throws Exception {
        ExecutorService guessers = Executors.newFixedThreadPool(16);
        // One client for all: connections that are kept alive count, too.
        TestHttpClient guesser = new TestHttpClient(thrifty, "");
        Map<Integer, Integer> answers = new ConcurrentHashMap<>();
        try {
            List<Future<Integer>> tries = IntStream.range(0, 1_000)
                    .mapToObj(number -> guessers.submit(() -> signIn(guesser, "guess" + number)))
                    .toList();
            for (Future<Integer> one : tries) {
                answers.merge(one.get(), 1, Integer::sum);
            }
        } finally {
            guessers.shutdownNow();
        }

        assertThat(new TreeMap<>(answers).keySet()).isSubsetOf(401, 429, 503);
        assertThat(answers.getOrDefault(401, 0)).as("passwords compared").isBetween(1, 60);
        assertThat(new TestHttpClient(thrifty, thrifty.key(Role.VIEWER))
                        .get("/api/v1/drones")
                        .status())
                .isEqualTo(200);
    }

    private static int signIn(TestHttpClient client, String password) {
        return client.post("/api/v1/session", "{\"name\":\"admin\",\"password\":\"" + password + "\"}")
                .status();
    }

    @Test
    void refusesMoreRequestsThanAUsersBudgetAndTellsHowLongToWait() {
        TestHttpClient busy = new TestHttpClient(thrifty, thrifty.key(Role.VIEWER));

        TestHttpClient.Answer refused = untilRefused(() -> busy.get("/api/v1/drones"));

        assertThat(refused.text("detail"))
                .matches("More than 10 requests a second for a while; wait \\d+ s and try again\\.");
        assertThat(refused.json().path("retryAfterSeconds").asInt()).isPositive();
        assertThat(refused.raw().headers().firstValue("Retry-After"))
                .hasValue(refused.json().path("retryAfterSeconds").asString());
        assertThat(new TestHttpClient(thrifty, thrifty.key(Role.VIEWER))
                        .get("/api/v1/drones")
                        .status())
                .as("another user")
                .isEqualTo(200);
    }

    private static TestHttpClient.Answer untilRefused(java.util.function.Supplier<TestHttpClient.Answer> ask) {
        for (int times = 0; times < 2_000; times++) {
            TestHttpClient.Answer answer = ask.get();
            if (answer.status() == 429) {
                return answer;
            }
        }
        throw new AssertionError("never refused");
    }

    @Test
    void refusesMoreCommandsThanABudgetInEveryFace() {
        String key = thrifty.key(Role.OPERATOR);
        TestHttpClient operator = new TestHttpClient(thrifty, key);

        TestHttpClient.Answer rest = spent(operator);
        TestHttpClient.Answer broadcast =
                operator.post("/api/v1/commands", "{\"drones\":[\"all\"],\"command\":{\"type\":\"arm\"}}");

        assertThat(rest.text("detail")).startsWith("More than 1 commands a second");
        assertThat(broadcast.status()).isEqualTo(429);
        assertThat(bySoap(operator, "arm"))
                .contains("problem:throttled</type>", "<retryAfterSeconds>")
                .containsPattern("<faultcode>\\w+:Client</faultcode>");
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(thrifty, key)) {
            stream.await(message -> message.path("type").asString().equals("drones"));
            assertThat(answer(stream, "arm")
                            .path("problem")
                            .path("retryAfterSeconds")
                            .asInt())
                    .isPositive();
        }
    }

    @Test
    void neverKeepsCommandsForSafetyWaiting() {
        String key = thrifty.key(Role.OPERATOR);
        TestHttpClient operator = new TestHttpClient(thrifty, key);
        spent(operator);

        try (RecordingStreamClient stream = RecordingStreamClient.withKey(thrifty, key)) {
            stream.await(message -> message.path("type").asString().equals("drones"));
            for (String safety : List.of("land", "returnToLaunch", "hold", "pauseMission")) {
                assertThat(operator.post(commands(), "{\"type\":\"" + safety + "\"}")
                                .status())
                        .as(safety)
                        .isNotEqualTo(429);
                assertThat(answer(stream, safety).path("problem").path("status").asInt())
                        .as(safety)
                        .isNotEqualTo(429);
            }
        }
        assertThat(bySoap(operator, "land")).contains("landResponse");
    }

    private String commands() {
        return "/api/v1/drones/" + vehicle.id() + "/commands";
    }

    private TestHttpClient.Answer spent(TestHttpClient operator) {
        return untilRefused(() -> operator.post(commands(), "{\"type\":\"setMode\",\"mode\":\"GUIDED\"}"));
    }

    private String bySoap(TestHttpClient operator, String operation) {
        return operator.send(
                        "/services/MAVLinkControllerService",
                        request -> request.header("Content-Type", "text/xml")
                                .POST(HttpRequest.BodyPublishers.ofString(soap(operation))))
                .raw()
                .body();
    }

    private String soap(String operation) {
        return "<s:Envelope xmlns:s=\"http://schemas.xmlsoap.org/soap/envelope/\""
                + " xmlns:w=\"http://cloud.dronemap.org/wsdl\"><s:Body><w:" + operation + "><droneId>" + vehicle.id()
                + "</droneId></w:" + operation + "></s:Body></s:Envelope>";
    }

    private JsonNode answer(RecordingStreamClient stream, String command) {
        stream.send("{\"type\":\"command\",\"requestId\":\"" + command + "\",\"drone\":\"" + vehicle.id()
                + "\",\"command\":{\"type\":\"" + command + "\"}}");
        return stream.await(message -> message.path("requestId").asString("").equals(command));
    }

    @Test
    void keepsControlWhenAUserAsksTooMuch() {
        TestHttpClient operator = new TestHttpClient(thrifty, thrifty.key(Role.OPERATOR));
        untilRefused(() -> operator.get("/api/v1/drones"));

        assertThat(operator.post("/api/v1/drones/" + vehicle.id() + "/control/heartbeat", "{}")
                        .status())
                .isNotEqualTo(429);
    }

    @Test
    void boundsTheStreamsOfEachUserAndGivesAPlaceBackWithEachThatIsClosed() {
        String key = thrifty.key(Role.VIEWER);
        try (RecordingStreamClient first = RecordingStreamClient.withKey(thrifty, key)) {
            first.await(message -> message.path("type").asString().equals("drones"));
            try (RecordingStreamClient second = RecordingStreamClient.withKey(thrifty, key);
                    RecordingStreamClient third = RecordingStreamClient.with(thrifty, "", Map.of())) {
                second.await(message -> message.path("type").asString().equals("drones"));
                third.send("{\"type\":\"authenticate\",\"key\":\"" + key + "\"}");
                JsonNode refused =
                        third.await(message -> message.path("type").asString().equals("error"));
                third.awaitClose();

                assertThat(refused.path("problem").path("status").asInt()).isEqualTo(429);
                assertThat(third.heard())
                        .noneMatch(message -> message.toString().contains("\"drones\""));
                try (RecordingStreamClient other = RecordingStreamClient.withKey(thrifty, thrifty.key(Role.VIEWER))) {
                    other.await(message -> message.path("type").asString().equals("drones"));
                }
            }
            ConditionWait.until("a place is free", () -> comesIn(key) ? Optional.of(true) : Optional.empty());
        }
    }

    private boolean comesIn(String key) {
        try (RecordingStreamClient again = RecordingStreamClient.withKey(thrifty, key)) {
            return again.await(message -> message.path("type").asString().matches("drones|error"))
                    .has("drones");
        }
    }

    @Test
    void countsFilesAndExportsApart() {
        TestHttpClient viewer = new TestHttpClient(thrifty, thrifty.key(Role.VIEWER));

        TestHttpClient.Answer refused = untilRefused(() -> viewer.get("/api/v1/recordings/nosuchrecording/file"));

        assertThat(refused.text("detail")).startsWith("More than 0.2 exports a second");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "GET /api/v1/audit/file",
                "POST /api/v1/backup",
                "GET /api/v1/drones/nosuchdrone/logs/1/file",
                "GET /api/v1/drones/nosuchdrone/parameters/file",
                "POST /api/v1/drones/nosuchdrone/parameters/file",
                "GET /api/v1/drones/nosuchdrone/telemetry/file",
                "GET /api/v1/flights/logbook",
                "GET /api/v1/flights/nosuchflight/telemetry/file",
                "POST /api/v1/recordings/nosuchrecording/replays",
                "POST /api/v1/replays",
                "POST /api/v1/zones/import"
            })
    void countsEachFileAsAnExport(String operation) {
        String[] words = operation.split(" ");
        TestHttpClient administrator = new TestHttpClient(thrifty, thrifty.key(Role.ADMINISTRATOR));

        TestHttpClient.Answer refused = untilRefused(() -> administrator.send(
                words[1],
                request -> request.header("Content-Type", "application/octet-stream")
                        .method(words[0], HttpRequest.BodyPublishers.ofString(words[0].equals("GET") ? "" : "{"))));

        assertThat(refused.text("detail")).startsWith("More than 0.2 exports a second");
    }

    @Test
    void countsWhatWasRefusedForMonitoring() {
        TestHttpClient viewer = new TestHttpClient(thrifty, thrifty.key(Role.VIEWER));
        untilRefused(() -> viewer.get("/api/v1/recordings/nosuchrecording/file"));

        assertThat(new TestHttpClient(thrifty, thrifty.key(Role.VIEWER))
                        .get("/metrics")
                        .raw()
                        .body())
                .containsPattern("dronemap_refused_work_total\\{work=\"export\"} [1-9]")
                .contains("dronemap_clients_cut_total{why=\"streams\"}");
    }
}
