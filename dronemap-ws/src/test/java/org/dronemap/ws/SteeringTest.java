package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Predicate;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.command.Setpoint.Facing;
import org.dronemap.core.command.Setpoint.Frame;
import org.dronemap.core.command.Setpoint.Velocity;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.ws.testserver.ConditionWait;
import org.dronemap.ws.testserver.OrganisationMember;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.java_websocket.exceptions.WebsocketNotConnectedException;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;

/** Drones steered through the stream, and standing as soon as whoever steered has gone or may no more. */
class SteeringTest {
    private static final Setpoint ROUND = new Velocity(Frame.VEHICLE, 0, 0, 0, new Facing.Turning(10));
    private static final Setpoint STILL = new Velocity(Frame.VEHICLE, 0, 0, 0, new Facing.Turning(0));
    private static final String TURN = "\"velocity\":{\"turn\":10}";

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestServer house = tenant.server();
    private ScriptedVehicle vehicle;
    private OrganisationMember root;
    private OrganisationMember ann;

    @BeforeEach
    void open() {
        vehicle = tenant.vehicle();
        vehicle.says(new DroneEvent.ModeReported("GUIDED", true));
        vehicle.says(new DroneEvent.PhaseReported(FlightPhase.IN_AIR));
        ConditionWait.until(
                "it flies", () -> state().filter(drone -> drone.airborne() && Boolean.TRUE.equals(drone.armed())));
        root = tenant.member("root", Role.ADMINISTRATOR);
        ann = tenant.member("ann", Role.OPERATOR);
    }

    private Optional<DroneState> state() {
        return house.cloud().drone(new DroneId(vehicle.id()));
    }

    @Test
    void steersAndStandsWhenHandsAreTakenOff() {
        try (RecordingStreamClient stream = entered(tenant.key(Role.OPERATOR))) {
            steer(stream, "\"velocity\":{\"frame\":\"vehicle\",\"forward\":2,\"right\":-1,\"down\":0.5,\"turn\":20}");
            awaitSaid(said -> said.contains(new Velocity(Frame.VEHICLE, 2, -1, 0.5, new Facing.Turning(20))));
            stream.send("{\"type\":\"letGo\",\"drone\":\"" + vehicle.id() + "\"}");
            awaitSaid(said -> said.contains(STILL));

            JsonNode turn = stream.await(message -> outcome(message).equals("succeeded"));
            assertThat(turn.path("command").path("summary").asString()).isEqualTo("steer by speeds");
            assertThat(turn.path("command").path("face").asString()).isEqualTo("stream");
        }
    }

    @Test
    void standsWhenTheConnectionEndsLongBeforeSetpointsExpire() {
        try (RecordingStreamClient others = entered(tenant.key(Role.VIEWER))) {
            try (RecordingStreamClient stream = entered(tenant.key(Role.OPERATOR))) {
                steer(stream, TURN);
                awaitSaid(said -> said.contains(ROUND));
            }
            awaitSaid(said -> said.contains(STILL));
            // Had it been silence, the turn would have timed out.
            others.await(message -> outcome(message).equals("succeeded"));
        }
    }

    @Test
    void whoIsDisabledInTheMiddleOfATurnSteersNoMoreAndHasNoControl() {
        for (int times = 0; times < 5; times++) {
            try (RecordingStreamClient stream = entered(ann.key())) {
                steer(stream, TURN);
                awaitSaid(said -> said.contains(ROUND));
                CompletableFuture<Integer> disabled = CompletableFuture.supplyAsync(() -> state("disabled"));
                steerUntilClosed(stream);
                assertThat(disabled.join()).isEqualTo(200);
                // Before it is closed it hears all that came of what it has said.
                stream.awaitClose();
                assertThat(house.cloud()
                                .controls()
                                .control(new DroneId(vehicle.id()))
                                .tenure())
                        .isNull();
                awaitSaid(said -> said.get(said.size() - 1).equals(STILL));
            }
            assertThat(state("active")).isEqualTo(200);
        }
    }

    @Test
    void aGrantThatIsTakenBackStopsWhatIsSteeredByIt() {
        call("PUT", "/api/v1/users/" + ann.name() + "/only-granted", "{\"onlyGranted\":true}");
        String grant = root.http()
                .post(
                        "/api/v1/grants",
                        "{\"user\":\"" + ann.name() + "\",\"drones\":[\"" + vehicle.id()
                                + "\"],\"operations\":[\"command\"]}")
                .text("id");
        try (RecordingStreamClient stream = entered(ann.key())) {
            steer(stream, TURN);
            awaitSaid(said -> said.contains(ROUND));
            call("DELETE", "/api/v1/grants/" + grant, "");
            awaitSaid(said -> said.contains(STILL));
            int before = vehicle.setpoints().size();
            steer(stream, TURN);
            stream.await(message -> message.path("type").asString().equals("error"));
            assertThat(vehicle.setpoints().subList(before, vehicle.setpoints().size()))
                    .doesNotContain(ROUND);
        }
    }

    private void steerUntilClosed(RecordingStreamClient stream) {
        while (true) {
            try {
                steer(stream, TURN);
            } catch (WebsocketNotConnectedException closed) {
                return;
            }
        }
    }

    private int state(String state) {
        return call("PATCH", "/api/v1/users/" + ann.name(), "{\"state\":\"" + state + "\"}");
    }

    private int call(String method, String path, String body) {
        return root.http()
                .send(
                        path,
                        request -> request.header("Content-Type", "application/json")
                                .method(method, HttpRequest.BodyPublishers.ofString(body)))
                .status();
    }

    @Test
    void isToldOnceASecondWhyNothingIsSteered() {
        vehicle.says(new DroneEvent.PhaseReported(FlightPhase.ON_GROUND));
        ConditionWait.until("it has landed", () -> state().filter(drone -> !drone.airborne()));
        try (RecordingStreamClient stream = entered(tenant.key(Role.OPERATOR))) {
            long began = System.nanoTime();
            for (int times = 0; times < 20; times++) {
                steer(stream, TURN);
            }
            stream.send("{\"type\":\"ping\"}");
            stream.await(message -> message.path("type").asString().equals("pong"));

            List<JsonNode> errors = stream.heard().stream()
                    .filter(message -> message.path("type").asString().equals("error"))
                    .toList();
            // One at once, and one for each second that it took to say all that.
            int seconds = (int) Duration.ofNanos(System.nanoTime() - began).toSeconds();
            assertThat(errors).hasSizeBetween(1, 2 + seconds);
            assertThat(errors.get(0).path("problem").path("detail").asString()).isEqualTo("Take off first.");
            assertThat(vehicle.setpoints()).isEmpty();
            ConditionWait.until(
                    "it is written down once", () -> Optional.of(records()).filter(count -> count == 1));
        }
    }

    private long records() {
        return house.records().stream()
                .filter(record -> record.entry().operation().equalsIgnoreCase("steer"))
                .filter(record -> vehicle.id().equals(record.entry().drone()))
                .count();
    }

    @Test
    void takesNoSpeedThatIsNoneAndNoStickThatIsOne() {
        try (RecordingStreamClient stream = entered(tenant.key(Role.OPERATOR))) {
            for (String wrong : List.of(
                    "\"epoch\":1",
                    "\"velocity\":{},\"sticks\":{}",
                    "\"velocity\":{\"forward\":101}",
                    "\"velocity\":{\"frame\":\"moon\"}",
                    "\"velocity\":{\"turn\":1,\"heading\":2}",
                    "\"sticks\":{\"up\":1.5}")) {
                int before = errors(stream);
                steer(stream, wrong);
                ConditionWait.until(wrong, () -> Optional.of(errors(stream)).filter(count -> count > before));
            }
            steer(stream, "\"sticks\":{\"forward\":0.5,\"turn\":-1}");
            awaitSaid(said -> said.contains(new Setpoint.Sticks(0.5, 0, 0, -1)));
        }
    }

    @Test
    void anEpochThatIsOverSteersNothing() {
        try (RecordingStreamClient stream = entered(tenant.key(Role.OPERATOR))) {
            steer(stream, TURN + ",\"epoch\":1");
            JsonNode error =
                    stream.await(message -> message.path("type").asString().equals("error"));
            assertThat(error.path("problem").path("status").asInt()).isEqualTo(409);
            assertThat(vehicle.setpoints()).isEmpty();
        }
    }

    private static int errors(RecordingStreamClient stream) {
        return (int) stream.heard().stream()
                .filter(message -> message.path("type").asString().equals("error"))
                .count();
    }

    /** Of a turn at the helm; what follows it is held by a command of its own. */
    private static String outcome(JsonNode message) {
        JsonNode command = message.path("command");
        boolean turn = command.path("summary").asString("").startsWith("steer by");
        return turn ? command.path("outcome").path("result").asString("") : "";
    }

    private RecordingStreamClient entered(String key) {
        RecordingStreamClient stream = RecordingStreamClient.withKey(house, key);
        stream.await(message -> message.path("type").asString().equals("drones"));
        return stream;
    }

    private void steer(RecordingStreamClient stream, String how) {
        stream.send("{\"type\":\"steer\",\"drone\":\"" + vehicle.id() + "\"," + how + "}");
    }

    private void awaitSaid(Predicate<List<Setpoint>> wanted) {
        ConditionWait.until(
                "the vehicle is told", () -> Optional.of(vehicle.setpoints()).filter(wanted));
    }
}
