package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.awaitility.Awaitility;
import org.dronemap.core.access.Role;
import org.dronemap.ws.guard.ClientLimits;
import org.dronemap.ws.house.Http;
import org.dronemap.ws.house.RawClient;
import org.dronemap.ws.house.ScriptedVehicle;
import org.dronemap.ws.house.StreamListener;
import org.dronemap.ws.house.TestHouse;
import org.dronemap.ws.service.Rates;
import org.dronemap.ws.wiring.Settings;
import org.dronemap.ws.wiring.StreamPort;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Clients that say a byte now and then, or never read, are cut; meanwhile everybody else is served. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class SlowClientsTest {
    private static final int CLIENTS = 60;
    private static final int CONNECTIONS = 150;
    private static final int REQUESTS = 40;
    private static final Duration LONG_ENOUGH = Duration.ofSeconds(30);
    private static final String UPGRADE = "GET /stream HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\n"
            + "Connection: Upgrade\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n";

    private TestHouse house;
    private ScriptedVehicle vehicle;
    private String key;
    private Http other;

    @BeforeAll
    void open(@TempDir Path data) {
        ClientLimits limits = new ClientLimits(CONNECTIONS, REQUESTS, Duration.ofSeconds(1));
        house = new TestHouse(data, TestHouse.Choices.protectedBy(new Settings.Protection(limits, Rates.UNBOUNDED)));
        vehicle = ScriptedVehicle.connect(house.cloud(), 15_700);
        key = house.key(Role.OPERATOR);
        other = new Http(house, key);
    }

    @AfterAll
    void close() {
        house.close();
    }

    static Stream<Arguments> dribbled() {
        String head = " HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n";
        return Stream.of(
                Arguments.of("nothing at all", ""),
                Arguments.of("half a line", "GET /api/v1/hea"),
                Arguments.of("headers without end", "GET /api/v1/health HTTP/1.1\r\nHost: localhost\r\nX-A: "),
                Arguments.of("half a body", "POST /api/v1/session" + head + "Content-Length: 60000\r\n\r\n{"),
                Arguments.of(
                        "half a body of pieces", "POST /api/v1/session" + head + "Transfer-Encoding: chunked\r\n\r\n"),
                Arguments.of(
                        "a body that nobody wants", "POST /api/v1/drones" + head + "Content-Length: 60000\r\n\r\n{"),
                Arguments.of(
                        "half a message of SOAP",
                        "POST /services/MAVLinkControllerService HTTP/1.1\r\nHost: localhost\r\n"
                                + "Content-Type: text/xml\r\nContent-Length: 60000\r\n\r\n<a>"));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("dribbled")
    void cutsWhoSendsAByteNowAndThen(String what, String beginning) {
        List<RawClient> slow = crowd(house.httpPort(), CLIENTS, beginning);
        try {
            awaitAllCut(slow, beginning.isEmpty() ? "" : piece(beginning));
        } finally {
            slow.forEach(RawClient::close);
        }
    }

    /** What goes on being sent, so that no silence gives the client away. */
    private static String piece(String beginning) {
        return beginning.contains("chunked") ? "1\r\n \r\n" : "a";
    }

    private void awaitAllCut(List<RawClient> slow, String piece) {
        List<RawClient> left = new ArrayList<>(slow);
        Awaitility.await("all are cut")
                .atMost(LONG_ENOUGH)
                .pollInterval(Duration.ofMillis(100))
                .until(() -> {
                    left.removeIf(client -> (!piece.isEmpty() && !client.say(piece)) || client.isClosedByServer());
                    othersAreServed();
                    return left.isEmpty();
                });
    }

    /** From the same host, which the slow ones have no more than their share of. */
    private void othersAreServed() {
        assertThat(other.get("/api/v1/drones").status()).isIn(200, 429);
    }

    private static List<RawClient> crowd(int port, int size, String beginning) {
        List<RawClient> clients = new ArrayList<>();
        IntStream.range(0, size).forEach(number -> {
            RawClient client = new RawClient(port);
            client.say(beginning);
            clients.add(client);
        });
        return clients;
    }

    @Test
    void givesNoHostMoreConnectionsThanItsShare() {
        List<RawClient> clients = crowd(house.httpPort(), CONNECTIONS + 20, "GET /api/v1/health HTTP/1.1\r\n");
        try {
            assertThat(clients.get(clients.size() - 1).hearAll()).isEmpty();
        } finally {
            clients.forEach(RawClient::close);
        }
        Awaitility.await("there is room again")
                .atMost(LONG_ENOUGH)
                .ignoreExceptions()
                .until(() -> other.get("/api/v1/drones").status() == 200);
    }

    static Stream<Arguments> handshakes() {
        return Stream.of(
                Arguments.of("nothing at all", ""),
                Arguments.of("half a handshake", "GET /stream HTTP/1.1\r\nHost: localhost\r\nX-A: "),
                Arguments.of("a handshake and no key", UPGRADE),
                // text, masked, of 200,000 bytes, and then not all of it
                Arguments.of("a handshake and half a message", UPGRADE + "\u0001\u007f"));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("handshakes")
    void cutsWhoDribblesAtTheStream(String what, String beginning) {
        int port = house.bean(StreamPort.class).number();
        List<RawClient> slow = crowd(port, CLIENTS, beginning);
        try {
            awaitAllCut(slow, what.startsWith("half") ? "a" : "");
            try (StreamListener listener = StreamListener.withKey(house, key)) {
                listener.await(message -> message.path("type").asString().equals("drones"));
            }
        } finally {
            slow.forEach(RawClient::close);
        }
    }

    @Test
    void cutsWhoMakesTheHandshakeLong() {
        try (RawClient client = new RawClient(house.bean(StreamPort.class).number())) {
            client.say("GET /stream HTTP/1.1\r\nHost: localhost\r\nX-A: ");
            int said = 0;
            while (said < 4_000_000 && client.say("a".repeat(1_000))) {
                said += 1_000;
            }
            assertThat(said).isLessThan(4_000_000);
        }
    }

    @Test
    void turnsAwayAtTheStreamWhoHasTooManyConnectionsAndGoesOnTakingOthers() {
        int port = house.bean(StreamPort.class).number();
        List<RawClient> many = crowd(port, 300, "GET /stream HTTP/1.1\r\n");
        try {
            assertThat(many.stream().filter(RawClient::isClosedByServer).count())
                    .isGreaterThan(100);
        } finally {
            many.forEach(RawClient::close);
        }
        Awaitility.await("others come in")
                .atMost(LONG_ENOUGH)
                .ignoreExceptions()
                .until(() -> {
                    try (StreamListener listener = StreamListener.withKey(house, key)) {
                        listener.await(
                                message -> message.path("type").asString().equals("drones"));
                        return true;
                    }
                });
    }

    @Test
    void commandsReachTheVehicleWhileSlowOnesWait() {
        List<RawClient> slow = crowd(
                house.httpPort(),
                CLIENTS,
                "POST /api/v1/session HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n"
                        + "Content-Length: 60000\r\n\r\n{");
        try (StreamListener stream = StreamListener.withKey(house, key)) {
            stream.await(message -> message.path("type").asString().equals("drones"));
            stream.send("{\"type\":\"command\",\"requestId\":\"r\",\"drone\":\"" + vehicle.id()
                    + "\",\"command\":{\"type\":\"setMode\",\"mode\":\"GUIDED\"}}");
            assertThat(stream.await(message ->
                                    message.path("requestId").asString("").equals("r"))
                            .path("type")
                            .asString())
                    .isEqualTo("commandAccepted");
        } finally {
            slow.forEach(RawClient::close);
        }
    }
}
