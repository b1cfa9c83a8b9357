package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronemap.core.access.Role;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;

/** The same mistake has the same code, parameters and sentence over REST, over SOAP and on the stream. */
class SameProblemTest {
    private static final Pattern CODE = Pattern.compile("<code>([^<]*)</code>");
    private static final Pattern SENTENCE = Pattern.compile("<faultstring>([^<]*)</faultstring>");
    private static final Pattern PARAMETER = Pattern.compile("<entry key=\"(\\w+)\" type=\"(\\w+)\">([^<]*)</entry>");
    private static final String COMMAND = "command";

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final ScriptedVehicle vehicle = tenant.vehicle();

    /** As a face tells it; each value with its type, and not the id of the command, which is new each time. */
    private record Told(String code, String sentence, Map<String, String> parameters) {}

    @Test
    void isToldOfADroneThatThereIsNot() {
        Told told = toldByAll(Role.OPERATOR, "nosuchdrone", "{\"type\":\"land\"}", "<w:land>%s</w:land>");

        assertThat(told)
                .isEqualTo(new Told(
                        "drone-unknown", "There is no drone nosuchdrone.", Map.of("drone", "string nosuchdrone")));
    }

    @Test
    void isToldOfANumberBeyondItsRange() {
        Told told = toldByAll(
                Role.OPERATOR,
                vehicle.id(),
                "{\"type\":\"takeOff\",\"altitude\":9000}",
                "<w:takeoff>%s<altitude>9000</altitude></w:takeoff>");

        assertThat(told.code()).isEqualTo("value-out-of-range");
        assertThat(told.parameters())
                .isEqualTo(Map.of(
                        "field", "string altitude",
                        "allowed", "string 1 to 500 m",
                        "least", "number 1",
                        "most", "number 500",
                        "unit", "string m"));
    }

    @Test
    void isToldOfAValueThatIsMissing() {
        Told told = toldByAll(
                Role.OPERATOR,
                vehicle.id(),
                "{\"type\":\"goTo\",\"longitude\":8,\"altitude\":20}",
                "<w:goto>%s<longitude>8</longitude><altitude>20</altitude></w:goto>");

        assertThat(told)
                .isEqualTo(new Told(
                        "value-missing",
                        "\"latitude\" is missing; it must be -90 to 90 degrees.",
                        Map.of("field", "string latitude", "allowed", "string -90 to 90 degrees")));
    }

    @Test
    void isToldOfARoleThatMayNotDoThis() {
        Told told = toldByAll(Role.VIEWER, vehicle.id(), "{\"type\":\"land\"}", "<w:land>%s</w:land>");

        assertThat(told.code()).isEqualTo("role-too-low");
        assertThat(told.parameters()).isEqualTo(Map.of("needed", "string planner", "role", "string viewer"));
    }

    @Test
    void isToldOfAValueThatIsNotAllowed() {
        Told told = toldByAll(
                Role.OPERATOR,
                vehicle.id(),
                "{\"type\":\"setRelay\",\"relay\":1,\"setting\":\"loop\"}",
                "<w:setRelay>%s<relay>1</relay><setting>loop</setting></w:setRelay>");

        assertThat(told.code()).isEqualTo("value-not-allowed");
        assertThat(told.parameters()).containsEntry("field", "string setting");
    }

    /** SOAP tells what the gate refuses as the outcome of the command, which the others look up. */
    @Test
    void isToldOfWhatTheGateRefuses() {
        String key = tenant.key(Role.OPERATOR);
        TestHttpClient http = new TestHttpClient(tenant.server(), key);
        String command = "{\"type\":\"setMode\",\"mode\":\"SPIRAL\"}";

        JsonNode rest = http.post("/api/v1/drones/" + vehicle.id() + "/commands", command)
                .json();
        String soap = answer(http, vehicle.id(), "<w:setMode>%s<mode>SPIRAL</mode></w:setMode>");

        assertThat(told(rest).code()).isEqualTo("mode-unknown");
        assertThat(told(rest).parameters()).isEqualTo(Map.of("drone", "string " + vehicle.id()));
        assertThat(onTheStream(key, vehicle.id(), command)).isEqualTo(told(rest));
        assertThat(only(CODE, soap)).isEqualTo("mode-unknown");
        assertThat(soap).contains("<reason>" + told(rest).sentence() + "</reason>");
        JsonNode kept = http.get("/api/v1/commands/" + rest.path("commandId").asString())
                .json()
                .path("outcome");
        assertThat(kept.path("code").asString()).isEqualTo("mode-unknown");
    }

    @Test
    void isToldOfControlThatAnotherUserHas() {
        TestHttpClient holder = tenant.http(Role.OPERATOR);
        assertThat(holder.post("/api/v1/drones/" + vehicle.id() + "/control/take", "{}")
                        .status())
                .isEqualTo(200);
        String key = tenant.key(Role.OPERATOR);

        Told rest = overRest(new TestHttpClient(tenant.server(), key), vehicle.id(), "{\"type\":\"arm\"}");

        assertThat(rest.code()).isEqualTo("control-held");
        assertThat(rest.parameters()).containsOnlyKeys("drone", "holder", "heldSince");
        assertThat(onTheStream(key, vehicle.id(), "{\"type\":\"arm\"}")).isEqualTo(rest);
        assertThat(answer(new TestHttpClient(tenant.server(), key), vehicle.id(), "<w:arm>%s</w:arm>"))
                .contains("<code>control-held</code>");
    }

    private Told toldByAll(Role role, String drone, String command, String operation) {
        String key = tenant.key(role);
        Told rest = overRest(new TestHttpClient(tenant.server(), key), drone, command);
        assertThat(overSoap(new TestHttpClient(tenant.server(), key), drone, operation))
                .isEqualTo(rest);
        assertThat(onTheStream(key, drone, command)).isEqualTo(rest);
        return rest;
    }

    private static Told overRest(TestHttpClient http, String drone, String command) {
        return told(http.post("/api/v1/drones/" + drone + "/commands", command).json());
    }

    private static String answer(TestHttpClient http, String drone, String operation) {
        String envelope = "<s:Envelope xmlns:s=\"http://schemas.xmlsoap.org/soap/envelope/\""
                + " xmlns:w=\"http://cloud.dronemap.org/wsdl\"><s:Body>"
                + operation.formatted("<droneId>" + drone + "</droneId>") + "</s:Body></s:Envelope>";
        return http.send(
                        "/services/MAVLinkControllerService",
                        request -> request.header("Content-Type", "text/xml")
                                .POST(HttpRequest.BodyPublishers.ofString(envelope)))
                .raw()
                .body();
    }

    private static Told overSoap(TestHttpClient http, String drone, String operation) {
        String fault = answer(http, drone, operation);
        Map<String, String> parameters = new TreeMap<>();
        PARAMETER.matcher(fault).results().forEach(found -> put(parameters, found));
        return new Told(only(CODE, fault), only(SENTENCE, fault), parameters);
    }

    private static void put(Map<String, String> parameters, MatchResult found) {
        if (!found.group(1).equals(COMMAND)) {
            parameters.put(found.group(1), found.group(2) + " " + found.group(3));
        }
    }

    private static String only(Pattern pattern, String fault) {
        Matcher found = pattern.matcher(fault);
        assertThat(found.find()).as(fault).isTrue();
        return found.group(1);
    }

    private Told onTheStream(String key, String drone, String command) {
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(tenant.server(), key)) {
            stream.await(message -> message.path("type").asString("").equals("hello"));
            stream.send("{\"type\":\"command\",\"requestId\":\"r1\",\"drone\":\"" + drone + "\",\"command\":" + command
                    + "}");
            return told(stream.await(
                            message -> message.path("requestId").asString("").equals("r1"))
                    .path("problem"));
        }
    }

    private static Told told(JsonNode problem) {
        Map<String, String> parameters = new TreeMap<>();
        problem.path("parameters").forEachEntry((name, value) -> {
            if (!name.equals(COMMAND)) {
                parameters.put(name, (value.isNumber() ? "number " : "string ") + value.asString());
            }
        });
        return new Told(problem.path("code").asString(), problem.path("detail").asString(), parameters);
    }
}
