package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.ChangeSpeed;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.SetCloudLossAction;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.core.parameter.ParameterType;
import org.dronemap.core.parameter.ParameterValue;
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
import org.junit.jupiter.params.provider.CsvSource;
import tools.jackson.databind.JsonNode;

class CommandsTest {
    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestServer house = tenant.server();
    private final String sameId = tenant.unique("the-same-id");
    private ScriptedVehicle vehicle;
    private String key;
    private TestHttpClient operator;
    private String commands;

    @BeforeEach
    void open() {
        vehicle = tenant.vehicle();
        key = tenant.key(Role.OPERATOR);
        operator = new TestHttpClient(house, key);
        commands = "/api/v1/drones/" + vehicle.id() + "/commands";
    }

    @Test
    void waitsForTheOutcome() {
        TestHttpClient.Answer answer = operator.post(commands + "?wait=10", "{\"type\":\"arm\"}");

        assertThat(answer.status()).isEqualTo(200);
        assertThat(answer.text("type")).isEqualTo("arm");
        assertThat(answer.text("phase")).isEqualTo("done");
        assertThat(answer.json().path("outcome").path("result").asString()).isEqualTo("succeeded");
        assertThat(operator.get("/api/v1/commands/" + answer.text("id")).json()).isEqualTo(answer.json());
        assertThat(vehicle.performed()).endsWith(new Command.Arm());
        assertThat(vehicle.performed()).first().isInstanceOf(SetCloudLossAction.class);
        assertThat(vehicle.performed()).hasSize(2);
    }

    @Test
    void anIdIsOfOneUserAndOfWhatWasSaidWithIt() {
        operator.post(commands + "?wait=10", "{\"type\":\"setMode\",\"mode\":\"AUTO\",\"id\":\"" + sameId + "\"}");

        TestHttpClient.Answer otherMode =
                operator.post(commands, "{\"type\":\"setMode\",\"mode\":\"GUIDED\",\"id\":\"" + sameId + "\"}");
        assertThat(otherMode.status()).isEqualTo(409);
        assertThat(otherMode.text("detail")).contains("belongs to another command");
        TestHttpClient.Answer otherUser = tenant.http(Role.SUPERVISOR)
                .post(commands, "{\"type\":\"setMode\",\"mode\":\"AUTO\",\"id\":\"" + sameId + "\"}");
        assertThat(otherUser.status()).isEqualTo(409);
    }

    /** Commands of several values whose words for people are the same. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "uploadMission|'items':[{'type':'waypoint','latitude':47.1,'longitude':8.1,'altitude':20}]|8.1|8.2",
                "setParameters|'parameters':[{'name':'A','value':1},{'name':'B','value':2}]|2}|3}",
                "goTo|'latitude':47.1,'longitude':8.1,'altitude':20|:20|:20.2",
                "setHome|'latitude':47.1,'longitude':8.1,'altitude':20|:20|:400",
                "startMission|'onCloudLoss':'continue'|continue|rtl",
                "turn|'degrees':20|:20|:20.2"
            })
    void anIdIsOfEachValueThatWasSaidWithIt(String type, String members, String value, String other) {
        String body = ("{'type':'" + type + "','id':'" + sameId + "'," + members + "}").replace('\'', '"');
        TestHttpClient.Answer first = operator.post(commands + "?wait=10", body);
        TestHttpClient.Answer again = operator.post(commands + "?wait=10", body);
        TestHttpClient.Answer changed = operator.post(commands, body.replace(value, other));

        assertThat(again.json().path("outcome")).isEqualTo(first.json().path("outcome"));
        assertThat(again.text("detail")).doesNotContain("belongs to another command");
        assertThat(changed.status()).isEqualTo(409);
        assertThat(changed.text("detail")).contains("belongs to another command");
    }

    @Test
    void actsOnceWhenTheSameIdComesTwice() {
        String body = "{\"type\":\"arm\",\"id\":\"" + sameId + "\"}";
        TestHttpClient.Answer first = operator.post(commands + "?wait=10", body);
        TestHttpClient.Answer second = operator.post(commands + "?wait=10", body);

        assertThat(second.json()).isEqualTo(first.json());
        assertThat(vehicle.performed())
                .filteredOn(Command.Arm.class::isInstance)
                .hasSize(1);
    }

    @Test
    void refusesAnIdThatBelongsToAnotherCommand() {
        operator.post(commands + "?wait=10", "{\"type\":\"arm\",\"id\":\"" + sameId + "\"}");
        TestHttpClient.Answer other =
                operator.post(commands, "{\"type\":\"setMode\",\"mode\":\"AUTO\",\"id\":\"" + sameId + "\"}");

        assertThat(other.status()).isEqualTo(409);
        assertThat(other.text("detail")).contains("belongs to another command");
    }

    @Test
    void tellsWhyTheGateRefusesInAllFaces() {
        TestHttpClient.Answer rest = operator.post(commands, "{\"type\":\"takeOff\",\"altitude\":20}");
        SoapClient.Answer soap =
                SoapClient.withKey(house, key).call("takeoff", "droneId", vehicle.id(), "altitude", 20.0);

        assertThat(rest.status()).isEqualTo(409);
        assertThat(rest.text("detail")).isEqualTo("Arm first.");
        JsonNode record =
                operator.get("/api/v1/commands/" + rest.text("commandId")).json();
        assertThat(record.path("outcome").path("result").asString()).isEqualTo("refused");
        assertThat(record.path("outcome").path("by").asString()).isEqualTo("gate");
        assertThat(List.of(soap.text("outcome.result"), soap.text("outcome.by"), soap.text("outcome.reason")))
                .containsExactly("refused", "gate", "Arm first.");
        assertThat(vehicle.performed()).isEmpty();
    }

    @Test
    void bringsTheVehiclesOwnSentenceToAllFaces() {
        String sentence = "PreArm: compass 7 not healthy";
        vehicle.ends(command -> new Outcome.Refused("vehicle", sentence, OutcomeCode.VEHICLE_REFUSED));
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, key)) {
            stream.await(message -> message.path("type").asString().equals("drones"));
            TestHttpClient.Answer rest = operator.post(commands + "?wait=10", "{\"type\":\"arm\"}");
            SoapClient.Answer soap = SoapClient.withKey(house, key).call("arm", "droneId", vehicle.id());
            JsonNode streamed = stream.await(
                    message -> message.path("command").path("id").asString("").equals(rest.text("id"))
                            && message.path("command").path("phase").asString().equals("done"));

            assertThat(rest.json().path("outcome").path("reason").asString()).isEqualTo(sentence);
            assertThat(rest.json().path("outcome").path("by").asString()).isEqualTo("vehicle");
            assertThat(soap.text("outcome.reason")).isEqualTo(sentence);
            assertThat(streamed.path("command").path("outcome").path("reason").asString())
                    .isEqualTo(sentence);
        }
    }

    @Test
    void setsAHomeThroughAllFaces() {
        operator.post(
                commands + "?wait=10",
                "{\"type\":\"setHome\",\"latitude\":47.5,\"longitude\":8.25,\"altitude\":500,"
                        + "\"altitudeReference\":\"amsl\"}");
        operator.post(commands + "?wait=10", "{\"type\":\"setHome\"}");
        SoapClient.withKey(house, key)
                .call(
                        "setHome",
                        "droneId",
                        vehicle.id(),
                        "latitude",
                        47.5,
                        "longitude",
                        8.25,
                        "altitude",
                        500.0,
                        "altitudeReference",
                        "amsl");
        TestHttpClient.Answer half = operator.post(commands, "{\"type\":\"setHome\",\"latitude\":47.5}");

        Command.SetHome there =
                new Command.SetHome(new Geodetic(47.5, 8.25), new Altitude(500, Altitude.Reference.AMSL));
        assertThat(vehicle.performed()).containsExactly(there, new Command.SetHome(null, null), there);
        assertThat(half.status()).isEqualTo(422);
        assertThat(half.text("field")).isEqualTo("longitude");
    }

    @Test
    void givesOtherOrdersThroughSoapAsThroughRest() {
        SoapClient soap = SoapClient.withKey(house, key);
        String drone = vehicle.id();
        vehicle.says(new DroneEvent.ParametersRead(List.of(new Parameter("RTL_ALT", ParameterType.INT32, 1500))));
        vehicle.says(new DroneEvent.ModeReported("GUIDED", true));
        vehicle.says(new DroneEvent.PhaseReported(FlightPhase.IN_AIR));
        ConditionWait.until(
                "it is known and in the air",
                () -> Optional.of(operator.get("/api/v1/drones/" + vehicle.id()).json())
                        .filter(seen -> seen.path("flight").asString("").equals("inAir")));

        assertThat(soap.call("listParameters", "droneId", drone, "search", "alt")
                        .text("parameters.item.value"))
                .isEqualTo("1500.0");
        assertThat(soap.call("readParameters", "droneId", drone).text("outcome.result"))
                .isEqualTo("succeeded");
        assertThat(soap.call("setParameter", "droneId", drone, "name", "RTL_ALT", "value", 2000.0)
                        .text("outcome.result"))
                .isEqualTo("succeeded");
        assertThat(soap.call("takePicture", "droneId", drone).text("outcome.result"))
                .isEqualTo("succeeded");
        assertThat(soap.call("turn", "droneId", drone, "degrees", -90.0).text("outcome.result"))
                .isEqualTo("succeeded");
        assertThat(soap.call("changeSpeed", "droneId", drone, "metersPerSecond", 4.5)
                        .text("outcome.result"))
                .isEqualTo("succeeded");
        assertThatThrownBy(() -> soap.call("setParameter", "droneId", drone, "name", "NOBODY", "value", 1.0))
                .isInstanceOf(SoapClient.Refused.class);
        assertThat(vehicle.performed())
                .containsExactly(
                        new Command.ReadParameters(),
                        new Command.SetParameters(List.of(new ParameterValue("RTL_ALT", 2000))),
                        new Command.TakePicture(),
                        new Command.Turn(-90),
                        new ChangeSpeed(4.5));
    }

    @Test
    void tellsTheHashOfTheMissionOnBoard() {
        vehicle.says(new DroneEvent.MissionRead(List.of(new MissionItem.Land()), "c0ffee", false));

        ConditionWait.until(
                "the mission is shown",
                () -> Optional.of(operator.get("/api/v1/drones/" + vehicle.id()).json())
                        .filter(drone ->
                                drone.path("mission").path("hash").asString("").equals("c0ffee")));
    }

    @Test
    void putsATakeOffInFrontOfAMissionThatHasNone() {
        operator.post(
                commands + "?wait=10",
                "{\"type\":\"uploadMission\",\"items\":[{\"type\":\"waypoint\",\"latitude\":47,\"longitude\":8,"
                        + "\"altitude\":35},{\"type\":\"returnToLaunch\"}]}");

        assertThat(vehicle.performed()).hasSize(1);
        assertThat(vehicle.performed().get(0)).isInstanceOfSatisfying(Command.UploadMission.class, upload -> {
            assertThat(upload.mission().items()).hasSize(3);
            assertThat(upload.mission().items().get(0)).isEqualTo(new MissionItem.TakeOff(35));
        });
    }

    @Test
    void warnsOfFarPlacesInAllFacesAndGoesOn() {
        String sentence = "Item 2 is 289.36 km away from the drone.";
        String far = "{\"type\":\"uploadMission\",\"items\":[{\"type\":\"waypoint\",\"latitude\":50,"
                + "\"longitude\":8.5456,\"altitude\":35}]}";

        TestHttpClient.Answer waited = operator.post(commands + "?wait=10", far);
        SoapClient.Answer soap = SoapClient.withKey(house, key)
                .call(
                        "uploadMission",
                        "droneId",
                        vehicle.id(),
                        "items",
                        List.of(Map.of("waypoint", Map.of("latitude", 50.0, "longitude", 8.5456, "altitude", 35.0))));
        TestHttpClient.Answer near = operator.post(commands + "?wait=10", far.replace(":50,", ":47.4,"));
        TestHttpClient.Answer atOnce = operator.post(commands, far);

        assertThat(waited.json().path("warnings").path(0).asString()).isEqualTo(sentence);
        assertThat(waited.json().path("outcome").path("result").asString()).isEqualTo("succeeded");
        assertThat(soap.texts("warnings.item")).containsExactly(sentence);
        assertThat(soap.text("outcome.result")).isEqualTo("succeeded");
        assertThat(near.json().path("warnings").isArray()).isTrue();
        assertThat(near.json().path("warnings").size()).isZero();
        assertThat(atOnce.json().path("warnings").path(0).asString()).isEqualTo(sentence);
    }

    @Test
    void listsTheCommandsOfADroneNewestFirst() {
        operator.post(commands + "?wait=10", "{\"type\":\"takePicture\"}");
        operator.post(commands + "?wait=10", "{\"type\":\"setMode\",\"mode\":\"AUTO\"}");

        JsonNode listed = operator.get(commands).json().path("commands");

        assertThat(listed.size()).isEqualTo(2);
        assertThat(listed.path(0).path("summary").asString()).isEqualTo("change mode to AUTO");
        assertThat(listed.path(0).path("face").asString()).isEqualTo("rest");
    }

    @Test
    void showsAbsentFactsAsNull() {
        vehicle.says(new DroneEvent.TextReported(org.dronemap.core.drone.Severity.INFO, "hello"));
        JsonNode drone = operator.get("/api/v1/drones/" + vehicle.id()).json();

        assertThat(drone.path("battery").isNull()).isTrue();
        assertThat(drone.path("home").isNull()).isTrue();
        assertThat(drone.path("mission").path("items").isNull()).isTrue();
        assertThat(drone.path("position").path("latitude").asDouble()).isEqualTo(47.3977);
        assertThat(drone.path("kind").asString()).isEqualTo("multicopter");
        assertThat(drone.path("actions").path("arm").path("allowed").asBoolean())
                .isTrue();
        assertThat(drone.path("actions").path("takeOff").path("why").asString()).isEqualTo("Arm first.");
    }
}
