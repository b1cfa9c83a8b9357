package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.awaitility.Awaitility;
import org.dronemap.core.access.Role;
import org.dronemap.ws.budget.BudgetRates;
import org.dronemap.ws.limit.ClientLimits;
import org.dronemap.ws.settings.ServerSettings;
import org.dronemap.ws.testserver.RawClient;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.wiring.StreamPort;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;

/** Clients that say a byte now and then, or never read, are cut; meanwhile everybody else is served. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class SlowClientsTest {
    private static final int CLIENTS = 30;
    private static final int CONNECTIONS = 300;
    private static final int REQUESTS = 40;
    private static final Duration LONG_ENOUGH = Duration.ofSeconds(30);
    private static final String UPGRADE = "GET /stream HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\n"
            + "Connection: Upgrade\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n";

    private TestServer house;
    private ScriptedVehicle vehicle;
    private String key;
    private TestHttpClient other;

    @BeforeAll
    void open(@TempDir Path data) {
        ClientLimits limits = new ClientLimits(CONNECTIONS, REQUESTS, Duration.ofSeconds(1));
        house = new TestServer(
                data, TestServer.Options.protectedBy(new ServerSettings.Protection(limits, BudgetRates.UNBOUNDED)));
        vehicle = ScriptedVehicle.connect(house.cloud(), 15_700);
        key = house.key(Role.OPERATOR);
        other = new TestHttpClient(house, key);
    }

    @AfterAll
    void close() {
        house.close();
    }

    /** Clients who begin alike, and go on saying {@code piece}, so that no silence gives them away; empty: nothing. */
    private record Crowd(String what, List<RawClient> left, String piece) {
        void forgetCut() {
            left.removeIf(client -> (!piece.isEmpty() && !client.say(piece)) || client.isClosedByServer());
        }

        @Override
        public String toString() {
            return left.size() + " who say " + what;
        }
    }

    private static Crowd crowd(int port, String what, String beginning, String piece) {
        return new Crowd(what, crowd(port, CLIENTS, beginning), piece);
    }

    private List<Crowd> ofHttp() {
        String head = " HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n";
        int port = house.httpPort();
        return List.of(
                crowd(port, "nothing at all", "", ""),
                crowd(port, "half a line", "GET /api/v1/hea", "a"),
                crowd(port, "headers without end", "GET /api/v1/health HTTP/1.1\r\nHost: localhost\r\nX-A: ", "a"),
                crowd(port, "half a body", "POST /api/v1/session" + head + "Content-Length: 60000\r\n\r\n{", "a"),
                crowd(
                        port,
                        "half a body of pieces",
                        "POST /api/v1/session" + head + "Transfer-Encoding: chunked\r\n\r\n",
                        "1\r\n \r\n"),
                crowd(
                        port,
                        "a body that nobody wants",
                        "POST /api/v1/drones" + head + "Content-Length: 60000\r\n\r\n{",
                        "a"),
                crowd(
                        port,
                        "half a message of SOAP",
                        "POST /services/MAVLinkControllerService HTTP/1.1\r\nHost: localhost\r\n"
                                + "Content-Type: text/xml\r\nContent-Length: 60000\r\n\r\n<a>",
                        "a"));
    }

    private List<Crowd> ofTheStream() {
        int port = house.bean(StreamPort.class).number();
        return List.of(
                crowd(port, "nothing at all to the stream", "", ""),
                crowd(port, "half a handshake", "GET /stream HTTP/1.1\r\nHost: localhost\r\nX-A: ", "a"),
                crowd(port, "a handshake and no key", UPGRADE, ""),
                // text, masked, of 200,000 bytes, and then not all of it
                crowd(port, "a handshake and half a message", UPGRADE + "\u0001\u007f", ""));
    }

    /** All at once: each has to wait until the server's patience is over. */
    @Test
    void cutsWhoDribblesAndServesOthersMeanwhile() {
        List<Crowd> slow = new ArrayList<>(ofHttp());
        slow.addAll(ofTheStream());
        List<RawClient> all =
                slow.stream().flatMap(crowd -> crowd.left().stream()).toList();
        assertThat(all).hasSize(11 * CLIENTS);
        try {
            Awaitility.await("all are cut")
                    .atMost(LONG_ENOUGH)
                    .pollInterval(Duration.ofMillis(100))
                    .until(() -> stillThere(slow), List::isEmpty);
            try (RecordingStreamClient listener = RecordingStreamClient.withKey(house, key)) {
                listener.await(message -> message.path("type").asString().equals("drones"));
            }
        } finally {
            all.forEach(RawClient::close);
        }
    }

    private List<Crowd> stillThere(List<Crowd> slow) {
        slow.forEach(Crowd::forgetCut);
        othersAreServed();
        return slow.stream().filter(crowd -> !crowd.left().isEmpty()).toList();
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
                    try (RecordingStreamClient listener = RecordingStreamClient.withKey(house, key)) {
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
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, key)) {
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
