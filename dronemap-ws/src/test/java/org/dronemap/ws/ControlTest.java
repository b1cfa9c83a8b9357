package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.http.HttpRequest;
import java.util.Optional;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.ws.testserver.ConditionWait;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.SoapClient;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import tools.jackson.databind.JsonNode;

/** Who commands a drone, through the faces. */
class ControlTest {
    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestServer house = tenant.server();
    private ScriptedVehicle vehicle;
    private String annsKey;
    private TestHttpClient ann;
    private TestHttpClient bob;
    private TestHttpClient supervisor;
    private String annsName;
    private String bobsName;
    private String control;
    private String commands;

    @BeforeEach
    void open() {
        vehicle = tenant.vehicle();
        annsKey = tenant.key(Role.OPERATOR);
        ann = new TestHttpClient(house, annsKey);
        bob = tenant.http(Role.OPERATOR);
        supervisor = tenant.http(Role.SUPERVISOR);
        control = "/api/v1/drones/" + vehicle.id() + "/control";
        commands = "/api/v1/drones/" + vehicle.id() + "/commands";
        annsName = nameOf(ann);
        bobsName = nameOf(bob);
    }

    @Test
    void takesControlWithTheFirstCommandAndTellsTheOtherWhoHasIt() {
        TestHttpClient.Answer first = ann.post(commands + "?wait=30", "{\"type\":\"arm\"}");
        TestHttpClient.Answer second = bob.post(commands, "{\"type\":\"arm\"}");

        assertThat(first.status()).isEqualTo(200);
        assertThat(first.json().path("epoch").asLong()).isPositive();
        assertThat(second.status()).isEqualTo(409);
        assertThat(second.text("detail")).startsWith(annsName + " has had control of it since 20");
        assertThat(second.text("holder")).isEqualTo(annsName);
        assertThat(second.text("heldSince")).startsWith("20");
        assertThat(bob.get("/api/v1/commands/" + second.text("commandId")).status())
                .isEqualTo(200);
        assertThat(vehicle.performed())
                .filteredOn(Command.Arm.class::isInstance)
                .hasSize(1);
        JsonNode seen = bob.get("/api/v1/drones/" + vehicle.id()).json().path("control");
        assertThat(seen.path("state").asString()).isEqualTo("held");
        assertThat(seen.path("holder").asString()).isEqualTo(annsName);
        assertThat(seen.path("explicit").asBoolean()).isFalse();
    }

    @Test
    void handsControlOverToWhoAsks() {
        assertThat(ann.post(control + "/take", "{}").text("holder")).isEqualTo(annsName);
        assertThat(bob.post(control + "/take", "{}").status()).isEqualTo(409);

        TestHttpClient.Answer asked = bob.post(control + "/request", "{\"reason\":\"my survey\"}");
        assertThat(asked.status()).isEqualTo(202);
        JsonNode request = ann.get(control).json().path("requests").get(0);
        assertThat(request.path("by").asString()).isEqualTo(bobsName);
        assertThat(request.path("reason").asString()).isEqualTo("my survey");

        assertThat(ann.post(control + "/refuse", user(bobsName)).status()).isEqualTo(200);
        assertThat(ann.post(control + "/grant", user(bobsName)).status()).isEqualTo(409);
        bob.post(control + "/request", "{}");
        assertThat(ann.post(control + "/grant", user(bobsName)).text("holder")).isEqualTo(bobsName);
        assertThat(bob.post(control + "/hand-over", user(annsName)).text("holder"))
                .isEqualTo(annsName);
        assertThat(ann.send(control, HttpRequest.Builder::DELETE).text("state")).isEqualTo("free");
    }

    @Test
    void letsOnlySupervisorsTakeOverAndOnlyWithAReason() {
        ann.post(control + "/take", "{}");

        assertThat(bob.post(control + "/take-over", "{\"reason\":\"mine\"}").status())
                .isEqualTo(403);
        TestHttpClient.Answer without = supervisor.post(control + "/take-over", "{}");
        assertThat(without.status()).isEqualTo(422);
        assertThat(without.text("field")).isEqualTo("reason");
        TestHttpClient.Answer taken = supervisor.post(control + "/take-over", "{\"reason\":\"smoke\"}");
        assertThat(taken.text("holder")).isEqualTo(nameOf(supervisor));
    }

    @Test
    void keepsControlByHeartbeatsOfTheRightEpoch() {
        long epoch = ann.post(control + "/take", "{}").json().path("epoch").asLong();

        assertThat(ann.post(control + "/heartbeat", "{\"epoch\":" + epoch + "}").status())
                .isEqualTo(200);
        TestHttpClient.Answer wrong = ann.post(control + "/heartbeat", "{\"epoch\":" + (epoch - 1) + "}");
        assertThat(wrong.status()).isEqualTo(409);
        assertThat(wrong.text("detail")).startsWith("Control by epoch " + (epoch - 1) + " has ended.");
        assertThat(wrong.text("code")).isEqualTo("control-ended");
        assertThat(ann.post(control + "/heartbeat", "{}").text("field")).isEqualTo("epoch");
        TestHttpClient.Answer stale = ann.post(commands, "{\"type\":\"arm\",\"epoch\":" + (epoch - 1) + "}");
        assertThat(stale.status()).isEqualTo(409);
        assertThat(stale.text("code")).isEqualTo("control-ended");
        assertThat(ann.post(commands, "{\"type\":\"arm\",\"epoch\":" + epoch + "}")
                        .status())
                .isLessThan(300);
    }

    @Test
    void givesControlToNobodyWhoMayNotCommand() {
        ann.post(control + "/take", "{}");
        String viewer = nameOf(tenant.http(Role.VIEWER));

        for (String user : new String[] {viewer, "nobody at all"}) {
            TestHttpClient.Answer refused = ann.post(control + "/hand-over", user(user));
            assertThat(refused.status()).isEqualTo(422);
            assertThat(refused.text("allowed")).isEqualTo("a user who may command drones");
        }
        assertThat(tenant.http(Role.PLANNER).post(control + "/take", "{}").status())
                .isEqualTo(403);
        assertThat(tenant.http(Role.REPORTER).get(control).status()).isEqualTo(403);
        assertThat(ann.get("/api/v1/drones/nothing/control").status()).isEqualTo(404);
    }

    static Stream<Arguments> foreign() {
        return Stream.of(
                Arguments.of("request", "request", "user", "reason"),
                Arguments.of("grant", "grant", "reason", "user"),
                Arguments.of("refuse", "refuse", "epoch", "user, reason"),
                Arguments.of("hand-over", "handOver", "epoch", "user"),
                Arguments.of("take-over", "takeOver", "user", "reason"),
                Arguments.of("heartbeat", "heartbeat", "reason", "epoch"));
    }

    @ParameterizedTest
    @MethodSource("foreign")
    void takesWhatBelongsToTheActionAlone(String address, String action, String member, String known) {
        String members = "\"" + member + "\":" + (member.equals("epoch") ? "1" : "\"" + bobsName + "\"");
        TestHttpClient.Answer refused = supervisor.post(control + "/" + address, "{" + members + "}");

        assertThat(refused.status()).isEqualTo(422);
        assertThat(refused.text("detail"))
                .isEqualTo("There is no member \"" + member + "\" here; there are: " + known + ".");
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, annsKey)) {
            stream.await(message -> isType(message, "drones"));
            stream.send("{\"type\":\"control\",\"drone\":\"" + vehicle.id() + "\",\"action\":\"" + action + "\","
                    + members + "}");
            JsonNode problem = stream.await(message -> isType(message, "error")).path("problem");
            assertThat(problem.path("detail").asString())
                    .isEqualTo("There is no member \"" + member + "\" here; there are: type, action, requestId, drone, "
                            + known + ".");
        }
        assertThat(ann.get(control).text("state")).isEqualTo("free");
    }

    @Test
    void tellsEverybodyWhoWatchesWhatBecomesOfControl() {
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, annsKey)) {
            stream.await(message -> isType(message, "drones"));
            stream.send("{\"type\":\"control\",\"requestId\":\"r1\",\"drone\":\"" + vehicle.id()
                    + "\",\"action\":\"take\"}");
            JsonNode answer = stream.await(message -> isType(message, "controlAnswer"));
            assertThat(answer.path("requestId").asString()).isEqualTo("r1");
            assertThat(answer.path("control").path("holder").asString()).isEqualTo(annsName);

            bob.post(control + "/request", "{\"reason\":\"please\"}");
            JsonNode request = stream.await(message -> isType(message, "control")
                    && message.path("change").path("kind").asString().equals("requested"));
            assertThat(request.path("change").path("by").asString()).isEqualTo(bobsName);
            assertThat(request.path("change").path("reason").asString()).isEqualTo("please");
            stream.await(message -> isType(message, "drone")
                    && message.path("drone").path("control").path("requests").size() == 1);

            stream.send("{\"type\":\"control\",\"drone\":\"" + vehicle.id() + "\",\"action\":\"fly\"}");
            JsonNode error = stream.await(message -> isType(message, "error"));
            assertThat(error.path("problem").path("field").asString()).isEqualTo("action");
        }
    }

    @Test
    void takesAndGivesBackBySoap() {
        SoapClient soap = SoapClient.withKey(house, annsKey);
        String drone = vehicle.id();
        SoapClient.Answer taken = soap.call("takeControl", "droneId", drone);

        assertThat(taken.text("holder")).isEqualTo(annsName);
        assertThat(soap.call("keepControl", "droneId", drone, "epoch", taken.text("epoch"))
                        .text("explicit"))
                .isEqualTo("true");
        assertThatThrownBy(() -> soap.call("takeOverControl", "droneId", drone, "reason", "mine"))
                .hasMessageContaining("supervisor");
        assertThatThrownBy(() -> soap.call("handOverControl", "droneId", drone, "user", bobsName, "reason", "a survey"))
                .hasMessage("There is no element \"reason\" here; there are: droneId, user.");
        assertThat(soap.call("handOverControl", "droneId", drone, "user", bobsName)
                        .text("holder"))
                .isEqualTo(bobsName);
        assertThatThrownBy(() -> soap.call("releaseControl", "droneId", drone))
                .hasMessageStartingWith("You do not have control. " + bobsName);
        assertThat(ann.post("/api/v1/drones/" + drone + "/control/hand-over", "{\"user\":\"" + bobsName + "\"}")
                        .text("code"))
                .isEqualTo("control-not-held");
        assertThat(soap.call("getControl", "droneId", drone).text("state")).isEqualTo("held");
    }

    @Test
    void letsASupervisorCallBackADroneThatAnotherFlies() {
        vehicle.says(new DroneEvent.ModeReported("GUIDED", true));
        vehicle.says(new DroneEvent.PhaseReported(FlightPhase.IN_AIR));
        ConditionWait.until(
                "it flies",
                () -> Optional.of(ann.get("/api/v1/drones/" + vehicle.id()).text("flight"))
                        .filter("inAir"::equals));
        ann.post(control + "/take", "{}");

        assertThat(bob.post(commands, "{\"type\":\"returnToLaunch\"}").status()).isEqualTo(409);
        assertThat(supervisor
                        .post(commands + "?wait=30", "{\"type\":\"returnToLaunch\"}")
                        .status())
                .isEqualTo(200);
        assertThat(ann.get(control).text("holder")).isEqualTo(annsName);
    }

    @Test
    void takesControlFromAUserWhoMayCommandNoMore() {
        ann.post(control + "/take", "{}");
        TestHttpClient administrator = tenant.http(Role.ADMINISTRATOR);

        administrator.send("/api/v1/users/" + annsName, HttpRequest.Builder::DELETE);

        assertThat(bob.get(control).text("state")).isEqualTo("free");
    }

    private static boolean isType(JsonNode message, String type) {
        return message.path("type").asString().equals(type);
    }

    private static String user(String name) {
        return "{\"user\":\"" + name + "\"}";
    }

    private static String nameOf(TestHttpClient who) {
        return who.get("/api/v1/session").text("name");
    }
}
