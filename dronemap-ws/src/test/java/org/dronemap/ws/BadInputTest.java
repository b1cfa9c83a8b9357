package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.SoapClient;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import tools.jackson.databind.JsonNode;

/** What is wrong is said the same way in REST, SOAP and the stream, and never reaches the vehicle. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class BadInputTest {
    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestServer house = tenant.server();
    private ScriptedVehicle vehicle;
    private String operatorKey;
    private TestHttpClient operator;

    @BeforeAll
    void open() {
        vehicle = tenant.vehicle();
        operatorKey = tenant.key(Role.OPERATOR);
        operator = new TestHttpClient(house, operatorKey);
    }

    @AfterEach
    void nothingReachedTheVehicle() {
        assertThat(vehicle.performed()).isEmpty();
    }

    static Stream<Arguments> badCommands() {
        String waypoint = "{\"type\":\"waypoint\",\"latitude\":47,\"longitude\":8";
        return Stream.of(
                Arguments.of(
                        "{\"type\":\"uploadMission\",\"items\":[" + waypoint + ",\"altitude\":20}," + waypoint + "}]}",
                        "items[1].altitude",
                        "-500 to 10000 m"),
                Arguments.of(
                        "{\"type\":\"uploadMission\",\"items\":[" + waypoint + ",\"altitude\":-501}]}",
                        "items[0].altitude",
                        "-500 to 10000 m"),
                Arguments.of(
                        "{\"type\":\"goTo\",\"latitude\":47,\"longitude\":8,\"altitude\":10001,"
                                + "\"altitudeReference\":\"amsl\"}",
                        "altitude",
                        "-500 to 10000 m"),
                Arguments.of(
                        "{\"type\":\"goTo\",\"latitude\":95,\"longitude\":8,\"altitude\":20}",
                        "latitude",
                        "-90 to 90 degrees"),
                Arguments.of(
                        "{\"type\":\"goTo\",\"latitude\":5,\"longitude\":-181,\"altitude\":20}",
                        "longitude",
                        "-180 to 180 degrees"),
                Arguments.of("{\"type\":\"takeOff\",\"altitude\":0.5}", "altitude", "1 to 500 m"),
                Arguments.of("{\"type\":\"takeOff\",\"altitude\":\"high\"}", "altitude", "a number"),
                Arguments.of("{\"type\":\"takeOff\",\"altitud\":5}", "altitud", "altitude"),
                Arguments.of("{\"type\":\"uploadMission\",\"items\":[]}", "items", "1 to 500 items"),
                Arguments.of("{\"type\":\"startMission\",\"onCloudLoss\":\"panic\"}", "onCloudLoss", "continue or rtl"),
                Arguments.of("{\"type\":\"arm\",\"altitude\":5}", "altitude", "type, id, epoch"),
                Arguments.of("{\"altitude\":5}", "type", "one of arm, disarm"),
                Arguments.of("{\"type\":\"fly\"}", "type", "one of arm, disarm"));
    }

    @ParameterizedTest
    @MethodSource("badCommands")
    void namesTheFieldAndWhatIsAllowedInRestAndStream(String command, String field, String allowed) {
        TestHttpClient.Answer rest = operator.post("/api/v1/drones/" + vehicle.id() + "/commands", command);

        assertThat(rest.status()).isEqualTo(422);
        assertThat(rest.raw().headers().firstValue("Content-Type")).hasValue("application/problem+json");
        assertThat(rest.text("field")).isEqualTo(field);
        assertThat(rest.text("allowed")).contains(allowed);
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, operatorKey)) {
            stream.send("{\"type\":\"command\",\"requestId\":\"r1\",\"drone\":\"" + vehicle.id() + "\",\"command\":"
                    + command + "}");
            JsonNode error =
                    stream.await(message -> message.path("type").asString().equals("error"));
            assertThat(error.path("problem").path("allowed").asString()).contains(allowed);
            assertThat(error.path("requestId").asString("")).isEqualTo("r1");
        }
    }

    @Test
    void namesTheMemberOfACommandForSeveral() {
        TestHttpClient.Answer type =
                operator.post("/api/v1/commands", "{\"drones\":\"all\",\"command\":{\"type\":\"fly\"}}");
        TestHttpClient.Answer member = operator.post(
                "/api/v1/commands", "{\"drones\":\"all\",\"command\":{\"type\":\"arm\",\"mode\":\"AUTO\"}}");

        assertThat(type.status()).isEqualTo(422);
        assertThat(type.text("field")).isEqualTo("command.type");
        assertThat(type.text("detail"))
                .startsWith("\"command.type\" must be one of arm, ")
                .endsWith(", not \"fly\".");
        assertThat(member.status()).isEqualTo(422);
        assertThat(member.text("detail"))
                .isEqualTo("There is no member \"command.mode\" here; there are: type, id, epoch.");
    }

    @Test
    void offersOnlyTypesThatItTakes() {
        TestHttpClient.Answer answer =
                operator.post("/api/v1/drones/" + vehicle.id() + "/commands", "{\"type\":\"fence\"}");

        assertThat(answer.status()).isEqualTo(422);
        assertThat(answer.text("allowed")).contains("readLogs").doesNotContain("fence", "rallyPoints");
    }

    @Test
    void saysTheSameSentenceInAllFaces() {
        String sentence = operator.post(
                        "/api/v1/drones/" + vehicle.id() + "/commands",
                        "{\"type\":\"goTo\",\"latitude\":95,\"longitude\":8,\"altitude\":20}")
                .text("detail");
        SoapClient.Refused fault = fault(
                operatorKey, "goto", "droneId", vehicle.id(), "latitude", 95.0, "longitude", 8.0, "altitude", 20.0);
        String streamed;
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, operatorKey)) {
            stream.send("{\"type\":\"command\",\"requestId\":\"r2\",\"drone\":\"" + vehicle.id()
                    + "\",\"command\":{\"type\":\"goTo\",\"latitude\":95,\"longitude\":8,\"altitude\":20}}");
            streamed = stream.await(
                            message -> message.path("requestId").asString("").equals("r2"))
                    .path("problem")
                    .path("detail")
                    .asString();
        }

        assertThat(sentence).isEqualTo("\"latitude\" must be -90 to 90 degrees, not 95.0.");
        assertThat(fault.getMessage()).isEqualTo(sentence);
        assertThat(fault.member("field")).isEqualTo("latitude");
        assertThat(fault.member("allowed")).isEqualTo("-90 to 90 degrees");
        assertThat(streamed).isEqualTo(sentence);
    }

    @Test
    void refusesAnAltitudeFarUnderTheGroundInSoapInTheWordsOfRest() {
        String sentence = operator.post(
                        "/api/v1/drones/" + vehicle.id() + "/commands",
                        "{\"type\":\"goTo\",\"latitude\":47,\"longitude\":8,\"altitude\":-10000}")
                .text("detail");
        SoapClient.Refused fault = fault(
                operatorKey,
                "goto",
                "droneId",
                vehicle.id(),
                "latitude",
                47.0,
                "longitude",
                8.0,
                "altitude",
                -10_000.0);

        assertThat(sentence).isEqualTo("\"altitude\" must be -500 to 10000 m, not -10000.0.");
        assertThat(fault.getMessage()).isEqualTo(sentence);
    }

    static Stream<Arguments> wrongItems() {
        String kinds = "takeOff, waypoint, returnToLaunch, land, wait, takePhoto, setServo, lookAt or lookAhead";
        return Stream.of(
                Arguments.of(
                        "{\"type\":\"returnToLaunch\",\"altitude\":5}",
                        "There is no member \"items[0].altitude\" here; there are: type."),
                Arguments.of(
                        "{\"type\":\"land\",\"altitude\":5}",
                        "\"items[0].latitude\" is missing; it must be -90 to 90 degrees."),
                Arguments.of(
                        "{\"type\":\"other\",\"description\":\"a jump\"}",
                        "\"items[0].type\" must be " + kinds + ", not \"other\"."),
                Arguments.of("{\"altitude\":5}", "\"items[0].type\" is missing; it must be " + kinds + "."));
    }

    @ParameterizedTest
    @MethodSource("wrongItems")
    void namesWhatAnItemOfAMissionCannotBeOrHave(String item, String sentence) {
        TestHttpClient.Answer answer = operator.post("/api/v1/missions", "{\"name\":\"A\",\"items\":[" + item + "]}");

        assertThat(answer.status()).isEqualTo(422);
        assertThat(answer.text("detail")).isEqualTo(sentence);
    }

    @Test
    void namesTheWaypointWithoutAltitudeInSoap() {
        Map<String, Object> good = Map.of("waypoint", Map.of("latitude", 47.0, "longitude", 8.0, "altitude", 20.0));
        Map<String, Object> bad = Map.of("waypoint", Map.of("latitude", 47.0, "longitude", 8.0));
        SoapClient.Refused fault =
                fault(operatorKey, "uploadMission", "droneId", vehicle.id(), "items", List.of(good, bad));

        assertThat(fault.member("field")).isEqualTo("items[1].altitude");
    }

    @Test
    void doesNotKnowAnUnknownDrone() {
        TestHttpClient.Answer rest = operator.post("/api/v1/drones/nosuchdrone/commands", "{\"type\":\"arm\"}");
        SoapClient.Refused fault = fault(operatorKey, "arm", "droneId", "nosuchdrone");

        assertThat(rest.status()).isEqualTo(404);
        assertThat(rest.text("detail")).isEqualTo("There is no drone nosuchdrone.");
        assertThat(fault.getMessage()).isEqualTo("There is no drone nosuchdrone.");
    }

    @Test
    void refusesAWrongKeyInAllFaces() {
        TestHttpClient.Answer rest = new TestHttpClient(house, "wrong").get("/api/v1/drones");
        SoapClient.Refused fault = fault("wrong", "arm", "droneId", vehicle.id());

        assertThat(rest.status()).isEqualTo(401);
        assertThat(rest.text("detail"))
                .isEqualTo("The access key is not valid; it may have been removed, renewed or expired.");
        assertThat(fault.getMessage()).isEqualTo(rest.text("detail"));
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, "wrong")) {
            assertThat(stream.awaitClose()).isEqualTo(rest.text("detail"));
        }
    }

    @Test
    void letsAViewerLookButNotArm() {
        String key = tenant.key(Role.VIEWER);
        TestHttpClient viewer = new TestHttpClient(house, key);

        TestHttpClient.Answer look = viewer.get("/api/v1/drones/" + vehicle.id());
        TestHttpClient.Answer arm = viewer.post("/api/v1/drones/" + vehicle.id() + "/commands", "{\"type\":\"arm\"}");
        SoapClient.Refused fault = fault(key, "arm", "droneId", vehicle.id());

        assertThat(look.status()).isEqualTo(200);
        assertThat(look.json().path("actions").path("arm").path("allowed").asBoolean())
                .isFalse();
        assertThat(arm.status()).isEqualTo(403);
        assertThat(arm.text("detail"))
                .isEqualTo("Your role may look, not command; ask an administrator for the operator role.");
        assertThat(fault.getMessage()).isEqualTo(arm.text("detail"));
    }

    @Test
    void saysWhereJsonBreaks() {
        TestHttpClient.Answer answer =
                operator.post("/api/v1/drones/" + vehicle.id() + "/commands", "{\"type\":\n \"arm\"");

        assertThat(answer.status()).isEqualTo(400);
        assertThat(answer.text("detail")).contains("line 2, column 7").doesNotContain("Exception");
    }

    @Test
    void saysWhatIsNoJsonInWordsForItsSenderNotForItsBuilder() {
        TestHttpClient.Answer answer = operator.post(
                "/api/v1/drones/" + vehicle.id() + "/commands", "{\"type\":\"takeOff\",\"altitude\":NaN}");

        assertThat(answer.status()).isEqualTo(400);
        assertThat(answer.text("detail")).isEqualTo("This is not JSON: line 1, column 33: Non-standard token 'NaN'.");
    }

    @Test
    void answersEveryMistakeOfHttpWithAProblem() {
        assertThat(operator.send("/api/v1/drones", request -> request.DELETE()).status())
                .isEqualTo(405);
        assertThat(operator.get("/api/v1/nothing").status()).isEqualTo(404);
        assertThat(operator.get("/api/v1/commands/nothing").text("detail")).isEqualTo("There is no command nothing.");
        assertThat(operator.post("/api/v1/missions", "{\"name\":\"" + "x".repeat(1_100_000) + "\"}")
                        .status())
                .isEqualTo(413);
        assertThat(new TestHttpClient(house, "").get("/api/v1/drones").status()).isEqualTo(401);
        assertThat(operator.post("/api/v1/drones/" + vehicle.id() + "/commands?wait=61", "{\"type\":\"arm\"}")
                        .text("allowed"))
                .isEqualTo("0 to 60 seconds");
    }

    @Test
    void refusesADoctypeInSoap() {
        TestHttpClient.Answer answer = operator.send(
                "/services/MAVLinkControllerService",
                request -> request.header("Content-Type", "text/xml")
                        .POST(java.net.http.HttpRequest.BodyPublishers.ofString(
                                "<!DOCTYPE x [<!ENTITY a \"b\">]><x>&a;</x>")));

        assertThat(answer.status()).isEqualTo(500);
        assertThat(answer.raw().body()).contains("must not have a DOCTYPE").doesNotContain("Exception");
    }

    private SoapClient.Refused fault(String key, String operation, Object... namesAndValues) {
        return catchThrowableOfType(
                SoapClient.Refused.class, () -> SoapClient.withKey(house, key).call(operation, namesAndValues));
    }
}
