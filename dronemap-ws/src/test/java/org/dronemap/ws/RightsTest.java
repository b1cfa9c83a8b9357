package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiPredicate;
import java.util.regex.Pattern;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.core.parameter.ParameterType;
import org.dronemap.ws.testserver.ExposedOperations;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.RightsTable;
import org.dronemap.ws.testserver.RightsTable.Caller;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.SharedServer;
import org.dronemap.ws.testserver.StreamRequestSamples;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import tools.jackson.databind.JsonNode;

/** Tries all that the running server exposes as everybody, and compares with what docs/security.md says. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class RightsTest {

    /** What the gate and the services say to roles that may not. */
    private static final Pattern ROLE_REFUSAL =
            Pattern.compile("Your role may .*|A planner may .*|Only an? .* may do this.*");

    private final Map<Caller, TestHttpClient> callers = new EnumMap<>(Caller.class);
    private final Map<Caller, String> keys = new EnumMap<>(Caller.class);
    private TestServer house;
    private ScriptedVehicle vehicle;
    private ExposedOperations faces;

    @BeforeAll
    void open() {
        house = SharedServer.get();
        vehicle = ScriptedVehicle.connect(house.cloud(), 20_000 + house.number());
        vehicle.says(new DroneEvent.ParametersRead(List.of(new Parameter("RTL_ALT", ParameterType.INT16, 1500))));
        for (Caller caller : Caller.values()) {
            keys.put(caller, caller.key(house));
            callers.put(caller, new TestHttpClient(house, keys.get(caller)));
        }
        faces = new ExposedOperations(house);
    }

    @Test
    void opensEachAddressOfRestToWhomTheTableSays() {
        compare("REST", faces.rest(), this::mayCall);
    }

    @Test
    void opensEachOperationOfSoapToWhomTheTableSays() {
        RightsTable table = RightsTable.below("REST");
        List<String> differences = new ArrayList<>();
        for (String operation : faces.soap()) {
            for (Caller caller : Caller.values()) {
                boolean opened = mayCallSoap(operation, caller);
                if (opened != table.promises(faces.restOf(operation), caller)) {
                    differences.add(operation + " is " + (opened ? "open" : "closed") + " to " + caller);
                }
            }
        }
        assertThat(differences).as("otherwise than the table says").isEmpty();
    }

    /** Who may not is told so whatever elements there are. */
    @Test
    void turnsAwayWhoMayNotWhateverTheCallOfSoapSays() {
        RightsTable table = RightsTable.below("REST");
        List<String> differences = new ArrayList<>();
        for (String operation : faces.soap()) {
            for (Caller caller : Caller.values()) {
                if (table.promises(faces.restOf(operation), caller)) {
                    continue;
                }
                Map<String, String> bad = new LinkedHashMap<>();
                faces.elements(operation).forEach(element -> bad.put(element.name(), "nosuchthing"));
                bad.put("nosuchelement", "x");
                String wrong = ExposedOperations.wrong(faces.soap(callers.get(caller), operation, bad));
                if (!wrong.equals(caller == Caller.NOBODY ? "not-signed-in" : "forbidden")) {
                    differences.add(operation + " for " + caller + ": " + wrong);
                }
            }
        }
        assertThat(differences).isEmpty();
    }

    @Test
    void takesFromEachClientOfTheStreamWhatTheTableSays() {
        compare("Stream", streamOperations(), this::maySay);
    }

    @Test
    void letsEachCommandThroughTheGateForWhomTheTableSays() {
        compare("Commands", commandTypes(), this::mayCommand);
    }

    private void compare(String heading, Set<String> exposed, BiPredicate<String, Caller> tried) {
        RightsTable table = RightsTable.below(heading);
        assertThat(table.operations()).as("listed and exposed").containsExactlyInAnyOrderElementsOf(exposed);
        List<String> differences = new ArrayList<>();
        for (String operation : exposed) {
            for (Caller caller : Caller.values()) {
                boolean opened = tried.test(operation, caller);
                if (opened != table.promises(operation, caller)) {
                    differences.add(operation + " is " + (opened ? "open" : "closed") + " to " + caller);
                }
            }
        }
        assertThat(differences).as("otherwise than the table says").isEmpty();
    }

    /** Of things that do not exist: whoever may is told so, whoever may not is told that instead. */
    private boolean mayCall(String operation, Caller caller) {
        TestHttpClient.Answer answer = faces.rest(callers.get(caller), operation, Map.of());
        assertThat(answer.status()).as(operation + " for " + caller).isNotIn(400, 405, 415, 500);
        return answer.status() != 401 && answer.status() != 403;
    }

    /** Who may not is told so before the server has read what was sent. */
    @Test
    void turnsAwayWhoMayNotWhateverTheBodyIs() {
        RightsTable table = RightsTable.below("REST");
        List<String> differences = new ArrayList<>();
        for (String operation : faces.rest()) {
            String[] words = operation.split(" ");
            for (Caller caller : Caller.values()) {
                if (words[0].equals("GET") || table.promises(operation, caller)) {
                    continue;
                }
                int status = callers.get(caller)
                        .send(
                                words[1].replaceAll("\\{number}", "1").replaceAll("\\{\\w+}", "nosuchthing"),
                                request -> request.header("Content-Type", "application/json")
                                        .method(words[0], HttpRequest.BodyPublishers.ofString("{")))
                        .status();
                if (status != (caller == Caller.NOBODY ? 401 : 403)) {
                    differences.add(operation + " for " + caller + ": " + status);
                }
            }
        }
        assertThat(differences).isEmpty();
    }

    private boolean mayCallSoap(String operation, Caller caller) {
        String answer =
                faces.soapAsRest(callers.get(caller), operation, Map.of()).raw().body();
        String wrong = ExposedOperations.wrong(answer);
        assertThat(!wrong.isEmpty() || answer.contains(operation + "Response"))
                .as(operation + " for " + caller + ": " + answer)
                .isTrue();
        assertThat(wrong).as(operation + " for " + caller).doesNotMatch("malformed|method|media-type|internal");
        return !wrong.matches("not-signed-in|forbidden");
    }

    /** As the stream itself names them to who says something else. */
    private Set<String> streamOperations() {
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, keys.get(Caller.VIEWER))) {
            stream.await(message -> message.path("type").asString().equals("drones"));
            stream.send("{\"type\":\"nosuchtype\"}");
            return words(stream.await(message -> message.path("type").asString().equals("error"))
                    .path("problem")
                    .path("allowed")
                    .asString());
        }
    }

    private boolean maySay(String type, Caller caller) {
        if (type.equals("authenticate")) {
            return isHeardOut(caller);
        }
        Map<String, String> headers =
                caller == Caller.NOBODY ? Map.of() : Map.of("Authorization", "Bearer " + keys.get(caller));
        try (RecordingStreamClient stream = RecordingStreamClient.with(house, "", headers)) {
            boolean inside = caller.compareTo(Caller.VIEWER) >= 0;
            if (inside) {
                stream.await(message -> message.path("type").asString().equals("drones"));
            }
            // A reporter is shown out before saying anything.
            if (inside || caller == Caller.NOBODY) {
                stream.send(StreamRequestSamples.about("nosuchdrone", type));
            }
            if (inside) {
                // What has no answer of its own is followed by what has.
                stream.send("{\"type\":\"nosuchtype\"}");
            }
            JsonNode first =
                    stream.await(message -> message.path("type").asString().matches("error|pong"));
            int status = first.path("problem").path("status").asInt();
            return status != 401 && status != 403;
        }
    }

    /** Anybody may try a key. */
    private boolean isHeardOut(Caller caller) {
        try (RecordingStreamClient stream = RecordingStreamClient.with(house, "", Map.of())) {
            stream.send("{\"type\":\"authenticate\",\"key\":\"" + keys.get(caller) + "\"}");
            String answer = stream.await(message -> true).toString();
            return !answer.contains("Send {");
        }
    }

    private Set<String> commandTypes() {
        return words(callers.get(Caller.OPERATOR)
                .post("/api/v1/drones/" + vehicle.id() + "/commands", "{\"type\":\"nosuchtype\"}")
                .text("allowed"));
    }

    private boolean mayCommand(String type, Caller caller) {
        TestHttpClient.Answer answer = callers.get(caller)
                .post(
                        "/api/v1/drones/" + vehicle.id() + "/commands",
                        faces.commands().least(type).toString());
        assertThat(answer.status()).as(type + " for " + caller).isNotIn(422, 500);
        return answer.status() != 401
                && !ROLE_REFUSAL.matcher(answer.text("detail")).matches();
    }

    private static Set<String> words(String list) {
        return Set.of(list.replaceFirst("^one of ", "").split(",? or |, "));
    }
}
