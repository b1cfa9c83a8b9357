package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.dronemap.core.audit.AuditEntry;
import org.dronemap.core.audit.AuditOutcome;
import org.dronemap.core.audit.AuditRecord;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.core.parameter.ParameterType;
import org.dronemap.ws.testserver.CommandBodies;
import org.dronemap.ws.testserver.ConditionWait;
import org.dronemap.ws.testserver.ExposedOperations;
import org.dronemap.ws.testserver.LoopbackAddressClient;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.RightsTable.Caller;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.SharedServer;
import org.dronemap.ws.testserver.StreamRequestSamples;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.springframework.web.servlet.mvc.method.annotation.RequestMappingHandlerMapping;
import tools.jackson.databind.JsonNode;

/** Tries all that the running server exposes: what may change something leaves exactly one record, whoever asks. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class AuditPolicyTest {
    private static final Set<String> LOOKING = Set.of("GET", "HEAD", "OPTIONS");
    private static final Set<String> DECIDED_BY_THE_SERVER = Set.of("rule", "safety", "virtual", "operation", "server");
    private static final List<Caller> CALLERS =
            List.of(Caller.NOBODY, Caller.REPORTER, Caller.VIEWER, Caller.OPERATOR, Caller.ADMINISTRATOR);
    private TestServer house;
    private ScriptedVehicle vehicle;
    private JsonNode description;

    @BeforeAll
    void open() {
        house = SharedServer.get();
        vehicle = ScriptedVehicle.connect(house.cloud(), 20_000 + house.number());
        vehicle.says(new DroneEvent.ParametersRead(List.of(new Parameter("RTL_ALT", ParameterType.INT16, 1500))));
        description = http(Caller.NOBODY).get("/api/openapi.json").json();
    }

    @Test
    void takesDownEachCallOfRestThatMayChangeSomethingAndNoOther() {
        List<String> wrong = new ArrayList<>();
        for (String operation : restOperations()) {
            String method = operation.substring(0, operation.indexOf(' '));
            boolean changes = operation.equals("GET /api/v1/session/oidc/callback")
                    || (!LOOKING.contains(method) && !operation.endsWith("/control/heartbeat"));
            for (Caller caller : CALLERS) {
                TestHttpClient http = http(caller);
                List<AuditEntry> left = left(() -> call(http, operation));
                boolean right =
                        changes ? left.size() == 1 && left.get(0).operation().equals(operation) : left.isEmpty();
                if (!right) {
                    wrong.add(operation + " by " + caller + " leaves " + left);
                }
            }
        }
        assertThat(wrong).isEmpty();
    }

    @Test
    void takesDownEachCallOfSoapThatMayChangeSomethingAndNoOther() {
        ExposedOperations faces = new ExposedOperations(house);
        List<String> wrong = new ArrayList<>();
        for (String operation : faces.soap()) {
            String rest = faces.restOf(operation);
            boolean changes = !rest.startsWith("GET ") && !rest.endsWith("/control/heartbeat");
            for (Caller caller : CALLERS) {
                List<AuditEntry> left = left(() -> faces.soapAsRest(http(caller), operation, Map.of()));
                boolean right = changes
                        ? left.size() == 1
                                && left.get(0).operation().equals(rest)
                                && left.get(0).face().equals("soap")
                                && namesIt(left.get(0), rest)
                        : left.isEmpty();
                if (!right) {
                    wrong.add(operation + " by " + caller + " leaves " + left);
                }
            }
        }
        assertThat(wrong).isEmpty();
    }

    /** The drone it is about, or what else, called as clients call it, and then never as a drone. */
    private static boolean namesIt(AuditEntry entry, String operation) {
        boolean ofDrone = operation.contains(" /api/v1/drones/{");
        boolean named =
                !operation.contains("{") || ofDrone || entry.parameters().contains("=nosuchthing");
        return named && (ofDrone ? "nosuchthing".equals(entry.drone()) : entry.drone() == null);
    }

    /** What REST can do as well is recorded by its name; the sample of control takes it. */
    private static final Map<String, String> IN_RECORD = Map.of(
            "command", "POST /api/v1/drones/{id}/commands",
            "control", "POST /api/v1/drones/{id}/control/take",
            "positions", "POST /api/v1/follows/{id}/positions");

    @Test
    void takesDownEachThingThatClientsOfTheStreamSayAndMayChangeSomething() {
        String key = key(Caller.OPERATOR);
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, key)) {
            stream.await(message -> message.path("type").asString().equals("drones"));
            stream.send("{\"type\":\"nosuchtype\",\"requestId\":\"0\"}");
            Set<String> types =
                    words(error(stream, "0").path("problem").path("allowed").asString());
            assertThat(types).contains("command", "control", "authenticate");
            int number = 0;
            for (String type : types) {
                String id = String.valueOf(++number);
                List<AuditEntry> left = left(() -> {
                            stream.send(StreamRequestSamples.about("nosuchdrone", type));
                            // Answered in order, so that all is done that came before it.
                            stream.send("{\"type\":\"nosuchtype\",\"requestId\":\"" + id + "\"}");
                            error(stream, id);
                        })
                        .stream()
                        .filter(entry -> !entry.operation().equals("unreadable"))
                        .toList();
                assertThat(left).as(type).hasSize(Set.of("ping", "subscribe").contains(type) ? 0 : 1);
                left.forEach(entry -> assertThat(entry.operation()).isEqualTo(IN_RECORD.getOrDefault(type, type)));
            }
        }
    }

    @Test
    void takesDownWhoIsShownTheDoorOfTheStream() {
        List<AuditEntry> left = left(() -> {
            try (RecordingStreamClient stream =
                    RecordingStreamClient.with(house, "?ticket=nosuchticket-canary", Map.of())) {
                stream.awaitClose();
            }
        });
        assertThat(left).hasSize(1);
        assertThat(left.get(0).operation()).isEqualTo("authenticate");
        assertThat(left.get(0).outcome()).isEqualTo(AuditOutcome.REFUSED);
        assertThat(left.toString()).doesNotContain("canary");
    }

    @Test
    void takesDownEachCommandOnceWithWhoWhichDroneAndHowItEnds() {
        TestHttpClient operator = http(Caller.OPERATOR);
        CommandBodies bodies = new CommandBodies(description);
        Set<String> types =
                words(operator.post(commands(), "{\"type\":\"nosuchtype\"}").text("allowed"));
        assertThat(types).hasSizeGreaterThan(15);
        for (String type : types) {
            List<AuditEntry> left = left(() ->
                    operator.post(commands() + "?wait=30", bodies.least(type).toString()));
            // What a rule does before it is no call of anybody.
            List<AuditEntry> asked =
                    left.stream().filter(entry -> !entry.face().equals("rule")).toList();
            assertThat(asked).as(type).hasSize(1);
            AuditEntry record = asked.get(0);
            assertThat(record.operation()).isEqualTo(type);
            assertThat(record.drone()).isEqualTo(vehicle.id());
            assertThat(record.by()).startsWith("user");
            assertThat(record.key()).isEqualTo("key-" + record.by());
            assertThat(record.command()).isNotNull();
            AuditEntry last = house.records().stream()
                    .map(AuditRecord::entry)
                    .filter(entry -> String.valueOf(record.command()).equals(entry.command()))
                    .reduce((first, second) -> second)
                    .orElseThrow();
            assertThat(last.outcome()).as(type).isIn(AuditOutcome.SUCCEEDED, AuditOutcome.REFUSED);
            assertThat(last.latencyMillis()).isNotNull();
        }
    }

    @Test
    void takesTheSameCommandTwiceDownAsTwoCallsOfWhichOneIsTheCommand() {
        TestHttpClient operator = http(Caller.OPERATOR);
        String body = "{\"type\":\"readHome\",\"id\":\"twice-the-same\"}";
        List<AuditEntry> first = left(() -> operator.post(commands() + "?wait=30", body));
        List<AuditEntry> second = left(() -> operator.post(commands() + "?wait=30", body));
        assertThat(first)
                .singleElement()
                .satisfies(entry -> assertThat(entry.command()).isEqualTo("twice-the-same"));
        assertThat(second)
                .singleElement()
                .satisfies(entry -> assertThat(entry.command()).isNull());
    }

    @Test
    void takesDownACommandForAllOnceForEachDrone() {
        List<AuditEntry> left = left(() -> http(Caller.OPERATOR)
                .post(
                        "/api/v1/commands?wait=30",
                        "{\"drones\":[\"" + vehicle.id() + "\"],\"command\":{\"type\":\"readHome\"}}"));
        assertThat(left).singleElement().satisfies(entry -> {
            assertThat(entry.operation()).isEqualTo("readHome");
            assertThat(entry.drone()).isEqualTo(vehicle.id());
        });
    }

    @Test
    void saysWhyAndByWhomWhatWasRefused() {
        TestHttpClient viewer = http(Caller.VIEWER);
        AuditEntry role =
                left(() -> viewer.post(commands(), "{\"type\":\"arm\"}")).get(0);
        assertThat(role.outcome()).isEqualTo(AuditOutcome.REFUSED);
        assertThat(role.by()).startsWith("user");
        assertThat(role.drone()).isEqualTo(vehicle.id());
        assertThat(role.reason()).contains("Your role may look");

        AuditEntry key = left(() -> new TestHttpClient(house, "nosuchkey").post("/api/v1/users", "{}"))
                .get(0);
        assertThat(key.by()).isNull();
        assertThat(key.outcome()).isEqualTo(AuditOutcome.REFUSED);
        assertThat(key.operation()).isEqualTo("POST /api/v1/users");
        assertThat(key.parameters()).contains("from 127.0.0.1");

        AuditEntry foreign = left(() ->
                        http(Caller.OPERATOR).post("/api/v1/drones/nosuchdrone/commands", "{\"type\":\"arm\"}"))
                .get(0);
        assertThat(foreign.reason()).contains("There is no drone nosuchdrone");
    }

    @Test
    void tellsWhoTakesControlUnderWhichEpochAndWhoIsHeldOff() {
        TestHttpClient one = http(Caller.OPERATOR);
        TestHttpClient other = http(Caller.OPERATOR);
        String control = "/api/v1/drones/" + vehicle.id() + "/control";
        AuditEntry take = left(() -> one.post(control + "/take", "")).get(0);
        assertThat(take.epoch()).isPositive();
        AuditEntry heldOff =
                left(() -> other.post(commands(), "{\"type\":\"setHome\"}")).get(0);
        assertThat(heldOff.operation()).isEqualTo("setHome");
        assertThat(heldOff.outcome()).isEqualTo(AuditOutcome.REFUSED);
        assertThat(heldOff.reason()).contains(String.valueOf(take.by()));
        left(() -> one.send(control, HttpRequest.Builder::DELETE));
    }

    @Test
    void takesDownControlThatLapsesThoughNobodyAskedForIt() {
        ScriptedVehicle left = ScriptedVehicle.connect(house.cloud(), 20_000 + house.number());
        int before = house.records().size();
        http(Caller.OPERATOR).post("/api/v1/drones/" + left.id() + "/control/take", "");

        AuditEntry lapse = ConditionWait.until(
                "control is lost",
                () -> since(before, left)
                        .filter(entry -> entry.operation().equals("controlLost"))
                        .findFirst());
        AuditEntry take = since(before, left).findFirst().orElseThrow();
        assertThat(lapse.face()).isEqualTo("rule");
        assertThat(lapse.drone()).isEqualTo(left.id());
        assertThat(lapse.parameters()).isEqualTo(take.by());
        assertThat(lapse.epoch()).isGreaterThan(take.epoch());
        assertThat(lapse.organisation()).isEqualTo("home");
    }

    private Stream<AuditEntry> since(int before, ScriptedVehicle about) {
        return house.records().stream()
                .skip(before)
                .map(AuditRecord::entry)
                .filter(entry -> about.id().equals(entry.drone()));
    }

    @Test
    void countsStrangersWhoAreManyInsteadOfListingEach() {
        LoopbackAddressClient nobody = new LoopbackAddressClient(house);
        for (int i = 0; i < 30; i++) {
            List<AuditEntry> left = left(() -> nobody.post("/api/v1/session", "{\"name\":\"x\",\"password\":\"y\"}"));
            assertThat(left).singleElement().satisfies(entry -> {
                assertThat(entry.outcome()).isEqualTo(AuditOutcome.REFUSED);
                assertThat(entry.parameters()).doesNotContain("x,");
            });
        }
    }

    private List<AuditEntry> left(Runnable work) {
        int before = house.records().size();
        work.run();
        List<AuditRecord> all = house.records();
        return all.subList(before, all.size()).stream()
                .map(AuditRecord::entry)
                .filter(entry -> entry.ends() == null && !isOfAnotherTest(entry) && !isExpiry(entry))
                .toList();
    }

    /** What the server decides meanwhile about drones that others of its tests have left. */
    private boolean isOfAnotherTest(AuditEntry entry) {
        return entry.drone() != null
                && !entry.drone().equals(vehicle.id())
                && DECIDED_BY_THE_SERVER.contains(entry.face());
    }

    /** Control that an earlier test took ends by itself, on a slow machine during a later one. */
    private static boolean isExpiry(AuditEntry entry) {
        return entry.operation().equals("controlExpired");
    }

    private String commands() {
        return "/api/v1/drones/" + vehicle.id() + "/commands";
    }

    private String key(Caller caller) {
        return caller.key(house);
    }

    private TestHttpClient http(Caller caller) {
        return new TestHttpClient(house, key(caller));
    }

    private Set<String> restOperations() {
        Set<String> operations = new TreeSet<>();
        house.bean(RequestMappingHandlerMapping.class)
                .getHandlerMethods()
                .keySet()
                .forEach(mapping -> mapping.getPatternValues().stream()
                        .filter(path -> path.startsWith("/api/v1/"))
                        .forEach(path -> mapping.getMethodsCondition()
                                .getMethods()
                                .forEach(method -> operations.add(method.name() + " " + path))));
        assertThat(operations).hasSizeGreaterThan(70);
        return operations;
    }

    private void call(TestHttpClient http, String operation) {
        String method = operation.substring(0, operation.indexOf(' '));
        String path = operation.substring(operation.indexOf(' ') + 1);
        http.send(
                path.replaceAll("\\{number}", "1").replaceAll("\\{\\w+}", "nosuchthing"),
                request -> request.header("Content-Type", contentType(method, path))
                        .method(method, HttpRequest.BodyPublishers.ofString(method.equals("GET") ? "" : "{}")));
    }

    private String contentType(String method, String path) {
        JsonNode content = description
                .path("paths")
                .path(path)
                .path(method.toLowerCase(Locale.ROOT))
                .path("requestBody")
                .path("content");
        return content.propertyNames().stream().findFirst().orElse("application/json");
    }

    private static JsonNode error(RecordingStreamClient stream, String id) {
        return stream.await(message -> message.path("type").asString().equals("error")
                && message.path("requestId").asString().equals(id));
    }

    private static Set<String> words(String list) {
        return Set.of(list.replaceFirst("^one of ", "").split(",? or |, "));
    }
}
