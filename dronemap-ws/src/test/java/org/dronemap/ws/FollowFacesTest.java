package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.http.HttpRequest;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.Command;
import org.dronemap.ws.testserver.ConditionWait;
import org.dronemap.ws.testserver.ExposedOperations;
import org.dronemap.ws.testserver.FollowStages;
import org.dronemap.ws.testserver.FollowStages.Staged;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What docs/following.md says comes of each operation at each stage does come of it, by REST and by SOAP; the stream shows it. */
class FollowFacesTest {
    private static final Map<String, String> SOAP = Map.of(
            "start", "startTracking",
            "cancel", "cancelFollowRequest",
            "pause", "disableTracking",
            "continue", "enableTracking",
            "stop", "stopTracking");

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestServer house = tenant.server();
    private ExposedOperations faces;
    private TestHttpClient phone;
    private TestHttpClient supervisor;
    private String supervisorKey;
    private FollowStages stages;

    /** One operation at one follow by one face. */
    private record Case(Staged follow, String operation, String next, Face face) {
        @Override
        public String toString() {
            return operation + " at " + follow.stage() + " by " + face;
        }
    }

    private enum Face {
        REST,
        SOAP
    }

    @BeforeEach
    void open() {
        faces = new ExposedOperations(house);
        phone = tenant.http(Role.OPERATOR);
        supervisorKey = tenant.key(Role.SUPERVISOR);
        supervisor = new TestHttpClient(house, supervisorKey);
        stages = new FollowStages(tenant, supervisor);
    }

    private boolean isTaken(Case one) {
        if (one.face() == Face.REST) {
            int status = byRest(one).status();
            assertThat(status).as(one.toString()).isIn(200, 409);
            return status == 200;
        }
        String operation = SOAP.get(one.operation());
        String answer =
                faces.soap(phone, operation, Map.of("followId", one.follow().id()));
        boolean refused = ExposedOperations.wrong(answer).equals("refused");
        assertThat(refused || answer.contains(operation + "Response"))
                .as(one + ": " + answer)
                .isTrue();
        return !refused;
    }

    private TestHttpClient.Answer byRest(Case one) {
        return one.operation().equals("change")
                ? phone.send(
                        one.follow().path(),
                        request -> request.header("Content-Type", "application/json")
                                .method("PATCH", HttpRequest.BodyPublishers.ofString("{\"distance\":20}")))
                : phone.post(one.follow().path() + "/" + one.operation(), "");
    }

    /** SOAP cannot change where the drone stays. */
    private static List<Face> facesOf(String operation) {
        return SOAP.containsKey(operation) ? List.of(Face.REST, Face.SOAP) : List.of(Face.REST);
    }

    @Test
    void doesWhatTheTableSaysByEachFace() throws IOException {
        List<Case> cases = new ArrayList<>();
        FollowStages.table().forEach((stage, all) -> {
            Staged untouched = stages.open(stage, phone);
            all.forEach((operation, next) -> {
                boolean isOperation = SOAP.containsKey(operation) || operation.equals("change");
                for (Face face : isOperation ? facesOf(operation) : List.<Face>of()) {
                    Staged follow = next.equals("no") ? untouched : stages.open(stage, phone);
                    cases.add(new Case(follow, operation, next, face));
                }
            });
        });
        assertThat(cases).hasSize(6 * 11);
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, supervisorKey)) {
            stages.bring();
            cases.forEach(one -> check(one, stream));
        }
    }

    private void check(Case one, RecordingStreamClient stream) {
        boolean allowed = !one.next().equals("no");
        assertThat(isTaken(one)).as(one.toString()).isEqualTo(allowed);
        List<String> expected = allowed
                ? List.of(one.next(), after(one.next()))
                : List.of(one.follow().stage());
        assertThat(stages.state(one.follow())).as(one.toString()).isIn(expected);
        stream.await(message -> message.path("follow")
                        .path("id")
                        .asString("")
                        .equals(one.follow().id())
                && expected.contains(message.path("follow").path("state").asString("")));
    }

    /** On from there it goes by itself. */
    private static String after(String stage) {
        return switch (stage) {
            case "starting" -> "tracking";
            case "returning" -> "over";
            default -> stage;
        };
    }

    @Test
    void bringsADroneHomeThatWhoeverHadItLeavesInTheAir() {
        Staged one = stages.open("tracking", phone);
        stages.bring();
        stages.takeOver(one);
        stages.await(one, "suspended");
        supervisor.send("/api/v1/drones/" + one.copter().id() + "/control", HttpRequest.Builder::DELETE);
        assertThat(phone.post(one.path() + "/stop", "").text("state")).isEqualTo("returning");
        ConditionWait.until(
                "it is called home",
                () -> one.copter().performed().stream()
                        .filter(Command.ReturnToLaunch.class::isInstance)
                        .findFirst());
    }
}
