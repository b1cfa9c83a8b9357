package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.dronemap.core.access.Role;
import org.dronemap.ws.access.HandlerCatalogue;
import org.dronemap.ws.access.RestOperation;
import org.dronemap.ws.stream.StreamAccessRule;
import org.dronemap.ws.stream.StreamFace;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.StreamRequestSamples;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tools.jackson.databind.JsonNode;

/** Who may do something on the stream may do it by REST, and nobody else: of what is not there both say the same to each. */
class StreamAccessTest {
    /** What is said on the stream, and the address of REST that does the same, with its method. */
    private static final Map<String, String> SAME = Map.of(
            control("take"), "POST /api/v1/drones/nosuchdrone/control/take",
            control("request"), "POST /api/v1/drones/nosuchdrone/control/request",
            control("grant"), "POST /api/v1/drones/nosuchdrone/control/grant",
            control("refuse"), "POST /api/v1/drones/nosuchdrone/control/refuse",
            control("handOver"), "POST /api/v1/drones/nosuchdrone/control/hand-over",
            control("takeOver"), "POST /api/v1/drones/nosuchdrone/control/take-over",
            control("heartbeat"), "POST /api/v1/drones/nosuchdrone/control/heartbeat",
            control("release"), "DELETE /api/v1/drones/nosuchdrone/control",
            StreamRequestSamples.about("nosuchdrone", "command"), "POST /api/v1/drones/nosuchdrone/commands",
            StreamRequestSamples.about("nosuchdrone", "positions"), "POST /api/v1/follows/nosuchfollow/positions");

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private static String control(String action) {
        return "{\"type\":\"control\",\"drone\":\"nosuchdrone\",\"action\":\"" + action + "\"}";
    }

    private static String body(String said) {
        if (said.contains("\"command\"")) {
            return "{\"type\":\"land\"}";
        }
        return said.contains("\"positions\"") ? "{\"sent\":\"2026-01-31T12:00:00Z\",\"positions\":[]}" : "{}";
    }

    @ParameterizedTest
    @EnumSource(
            value = Role.class,
            names = {"VIEWER", "PLANNER", "OPERATOR", "SUPERVISOR", "ADMINISTRATOR"})
    void isJudgedAsByRest(Role role) {
        String key = tenant.key(role);
        TestHttpClient rest = new TestHttpClient(tenant.server(), key);
        List<String> differences = new ArrayList<>();
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(tenant.server(), key)) {
            stream.await(message -> message.path("type").asString().equals("drones"));
            SAME.forEach((said, operation) -> {
                stream.send(said.replaceFirst("\\{", "{\"requestId\":\"" + operation + "\","));
                JsonNode problem = stream.await(message ->
                                message.path("requestId").asString("").equals(operation))
                        .path("problem");
                TestHttpClient.Answer answer = answer(rest, operation, body(said));
                if (answer.status() != problem.path("status").asInt()
                        || !answer.text("detail").equals(problem.path("detail").asString())) {
                    differences.add(operation + ": " + answer.status() + ", but on the stream " + problem);
                }
            });
        }

        assertThat(differences).isEmpty();
    }

    private static TestHttpClient.Answer answer(TestHttpClient rest, String operation, String body) {
        String[] words = operation.split(" ");
        return words[0].equals("DELETE") ? rest.send(words[1], HttpRequest.Builder::DELETE) : rest.post(words[1], body);
    }

    @Test
    void eachRequestNamesItsOperationsOrWhyThereAreNone() {
        List<String> operations = HandlerCatalogue.all().stream()
                .map(RestOperation::id)
                .filter(Objects::nonNull)
                .toList();

        assertThat(tenant.server().bean(StreamFace.class).requests().types()).allSatisfy((type, request) -> {
            if (request.access() instanceof StreamAccessRule.StreamOnly<?> only) {
                assertThat(only.why()).matches("[A-Z].{20,}\\.");
            } else {
                assertThat(request.access().operations()).isNotEmpty().isSubsetOf(operations);
            }
        });
    }

    @Test
    void anActionThatThereIsNotIsNamed() {
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(tenant.server(), tenant.key(Role.OPERATOR))) {
            stream.send(control("steal"));
            JsonNode problem = stream.await(
                            message -> message.path("type").asString().equals("error"))
                    .path("problem");

            assertThat(problem.path("field").asString()).isEqualTo("action");
            assertThat(problem.path("allowed").asString())
                    .contains("take, request")
                    .contains("release");
        }
    }
}
