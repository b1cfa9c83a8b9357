package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandPhase;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.ws.stream.StreamFace;
import org.dronemap.ws.testserver.ConditionWait;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.dronemap.ws.wiring.StreamPort;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;

class StreamTest {
    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestServer house = tenant.server();
    private ScriptedVehicle vehicle;
    private String key;

    @BeforeEach
    void open() {
        vehicle = tenant.vehicle();
        key = tenant.key(Role.OPERATOR);
    }

    @Test
    void greetsAndListsAllDronesFirst() {
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, key)) {
            JsonNode list = stream.await(message -> isType(message, "drones"));

            assertThat(stream.heard().get(0).path("type").asString()).isEqualTo("hello");
            assertThat(stream.heard().get(0).path("role").asString()).isEqualTo("operator");
            assertThat(list.path("drones").path(0).path("id").asString()).isEqualTo(vehicle.id());
        }
    }

    @Test
    void sendsTheNewestStateAndNotEveryOne() {
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, key)) {
            stream.await(message -> isType(message, "drones"));
            for (int percent = 1; percent <= 100; percent++) {
                vehicle.says(new DroneEvent.BatteryReported(new Battery(percent, null, null)));
            }

            stream.await(message -> percent(message) == 100);

            long pictures = stream.heard().stream()
                    .filter(message -> isType(message, "drone"))
                    .count();
            assertThat(pictures).isBetween(1L, 10L);
        }
    }

    @Test
    void refusesARateThatNobodyCanDraw() {
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, key)) {
            stream.await(message -> isType(message, "drones"));
            stream.send("{\"type\":\"subscribe\",\"rate\":51,\"requestId\":\"r\"}");
            JsonNode answer = stream.await(message -> isType(message, "error"));
            assertThat(answer.path("problem").path("field").asString()).isEqualTo("rate");
            assertThat(answer.path("problem").path("allowed").asString()).contains("1 to 50");
        }
    }

    @Test
    void refusesToFollowADroneThatIsNone() {
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, key)) {
            stream.await(message -> isType(message, "drones"));
            stream.send("{\"type\":\"subscribe\",\"drones\":[null],\"requestId\":\"r\"}");
            JsonNode answer = stream.await(message -> isType(message, "error"));
            assertThat(answer.path("problem").path("field").asString()).startsWith("drones");
        }
    }

    @Test
    void takesATicketOnce() {
        String ticket = new TestHttpClient(house, key)
                .post("/api/v1/stream-tickets", "")
                .text("ticket");

        try (RecordingStreamClient first = RecordingStreamClient.with(house, "?ticket=" + ticket, Map.of());
                RecordingStreamClient second = RecordingStreamClient.with(house, "?ticket=" + ticket, Map.of())) {
            first.await(message -> isType(message, "drones"));
            assertThat(second.awaitClose()).contains("ticket was used already");
        }
    }

    @Test
    void takesAKeyAsFirstMessage() {
        try (RecordingStreamClient stream = RecordingStreamClient.with(house, "", Map.of())) {
            stream.send("{\"type\":\"authenticate\",\"key\":\"" + key + "\"}");

            assertThat(stream.await(message -> isType(message, "hello"))
                            .path("user")
                            .asString())
                    .startsWith("user");
        }
    }

    @Test
    void turnsAPageOfAnotherSiteAway() {
        try (RecordingStreamClient stream = RecordingStreamClient.with(
                house, "", Map.of("Authorization", "Bearer " + key, "Origin", "https://evil.example"))) {
            assertThat(stream.awaitClose()).contains("only pages of its own host");
        }
    }

    @Test
    void commandsAndTellsEveryPhase() {
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, key)) {
            stream.send("{\"type\":\"command\",\"requestId\":\"r1\",\"drone\":\"" + vehicle.id()
                    + "\",\"command\":{\"type\":\"arm\"}}");
            String id = stream.await(message -> isType(message, "commandAccepted"))
                    .path("command")
                    .path("id")
                    .asString();
            stream.await(message -> isPhase(message, id, "done"));

            List<String> phases = stream.heard().stream()
                    .filter(message -> isType(message, "command"))
                    .map(message -> message.path("command"))
                    .filter(command -> command.path("id").asString().equals(id))
                    .map(command -> command.path("phase").asString())
                    .toList();
            assertThat(phases).containsExactly("sent", "accepted", "done");
            assertThat(vehicle.performed())
                    .filteredOn(Command.Arm.class::isInstance)
                    .hasSize(1);
        }
    }

    @Test
    void closesAClientThatDoesNotReadAndServesTheOthers() throws IOException {
        StreamFace face = house.bean(StreamFace.class);
        CommandRecord large = new CommandRecord(
                new CommandId("a-large-command"),
                new DroneId(vehicle.id()),
                "somebody",
                "rest",
                "Arm",
                "x".repeat(10_000),
                Instant.EPOCH,
                CommandPhase.SENT,
                null,
                null,
                null,
                null);
        ConditionWait.until(
                "those of earlier tests have left", () -> clients() == 0 ? Optional.of(true) : Optional.empty());
        try (Socket deaf = new Socket();
                RecordingStreamClient other = RecordingStreamClient.withKey(house, key)) {
            deaf.setReceiveBufferSize(1024);
            deaf.connect(new InetSocketAddress(
                    "127.0.0.1", house.bean(StreamPort.class).number()));
            upgrade(deaf);
            other.await(message -> isType(message, "drones"));
            ConditionWait.until("both are there", () -> clients() == 2 ? Optional.of(true) : Optional.empty());

            ConditionWait.until("the deaf one is closed", () -> {
                for (int count = 0; count < 50; count++) {
                    face.news().commandChanged(large);
                }
                return clients() == 1 ? Optional.of(true) : Optional.empty();
            });

            other.send("{\"type\":\"ping\"}");
            other.await(message -> isType(message, "pong"));
        }
    }

    @Test
    void whoIsNotSignedInMaySayAFewKilobytesAtATime() {
        try (RecordingStreamClient stream = RecordingStreamClient.with(house, "", Map.of())) {
            stream.sendInPieces("a".repeat(9_000), 1_000);

            assertThat(stream.awaitClose()).contains("8192 bytes");
        }
    }

    @Test
    void aMessageMayHave256KilobytesInPiecesToo() {
        String ping = "{\"type\":\"ping\"}";
        String largest = ping + " ".repeat(256 * 1024 - ping.length());
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, key)) {
            stream.await(message -> isType(message, "drones"));
            stream.sendInPieces(largest, 1_000);
            stream.await(message -> isType(message, "pong"));

            stream.sendInPieces(largest + " ", 1_000);
            assertThat(stream.awaitClose()).contains("262144 bytes");
        }
    }

    private int clients() {
        return house.bean(StreamFace.class).clientCount();
    }

    /** Opens the stream by hand and then reads nothing any more. */
    private void upgrade(Socket socket) throws IOException {
        OutputStream out = socket.getOutputStream();
        out.write(("GET /stream HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                        + "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n"
                        + "Authorization: Bearer " + key + "\r\n\r\n")
                .getBytes(StandardCharsets.US_ASCII));
        InputStream in = socket.getInputStream();
        assertThat(new String(in.readNBytes(12), StandardCharsets.US_ASCII)).isEqualTo("HTTP/1.1 101");
    }

    private static boolean isType(JsonNode message, String type) {
        return message.path("type").asString("").equals(type);
    }

    private static boolean isPhase(JsonNode message, String id, String phase) {
        JsonNode command = message.path("command");
        return isType(message, "command")
                && command.path("id").asString("").equals(id)
                && command.path("phase").asString("").equals(phase);
    }

    private static int percent(JsonNode message) {
        return message.path("drone").path("battery").path("percent").asInt(0);
    }
}
