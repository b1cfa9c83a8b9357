package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronemap.core.access.Role;
import org.dronemap.ws.testserver.OrganisationFixture;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.ResourceScopeTable.Whose;
import org.dronemap.ws.testserver.RightsTable;
import org.dronemap.ws.testserver.RightsTable.Caller;
import org.dronemap.ws.testserver.TestHttpClient;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;

/**
 * Tries all that the running server exposes, for each role, on drones and things of the own organisation, of another one and
 * on none; and compares with what docs/security.md says. What is foreign is answered as what is absent.
 */
class ReachTest extends ReachTrial {
    private static final String RECORDS = "GET /api/v1/audit";

    @Test
    void saysOfEachOperationWhatItIsAbout() {
        assertThat(faces.rest())
                .allSatisfy(operation ->
                        assertThat(whose.of(operation)).as(operation).isPresent());
    }

    @Test
    void answersOwnThingsAsTheRoleMayAndForeignOnesAsAbsentOnesThroughRest() {
        RightsTable table = RightsTable.below("REST");
        int cells = 0;
        for (String operation : faces.rest()) {
            String kind = kind(operation);
            if (foreign.thing(kind).isEmpty() || !operation.contains("{")) {
                continue;
            }
            for (Role role : Role.values()) {
                if (isTried(operation)) {
                    boolean promised = table.promises(operation, Caller.valueOf(role.name()));
                    judge(operation + " for " + role, promised, rest(ours.get(role), operation, ownThing(operation)));
                    cells++;
                }
                // Whoever runs the server takes back what was given away from there.
                if (role != Role.ADMINISTRATOR || !isTakingBack(operation)) {
                    alike(ours.get(role), operation, foreign.thing(kind).orElseThrow());
                }
                cells += 2;
            }
        }
        assertThat(wrong).isEmpty();
        assertThat(cells).isGreaterThan(800);
    }

    @Test
    void leavesTheServerToItsOwnPeople() {
        for (String operation : faces.rest()) {
            if (whose.of(operation).filter(Whose.SERVER::equals).isPresent()) {
                for (Role role : Role.values()) {
                    TestHttpClient.Answer answer = rest(theirs.get(role), operation, ABSENT);
                    if (answer.status() != 403) {
                        wrong.add(operation + " for their " + role + ": " + answer.status());
                    }
                }
            }
        }
        assertThat(wrong).isEmpty();
    }

    @Test
    void namesNothingOfAnotherOrganisationInAnyList() {
        for (String operation : faces.rest()) {
            if (operation.startsWith("GET ") && !operation.contains("{") && !operation.startsWith(RECORDS)) {
                for (Role role : Role.values()) {
                    silent(operation + " for our " + role, rest(ours.get(role), operation, ABSENT), foreign);
                    silent(operation + " for their " + role, rest(theirs.get(role), operation, ABSENT), own);
                }
            }
        }
        assertThat(wrong).isEmpty();
    }

    @Test
    void namesNothingOfAnotherOrganisationInAnyListOfSoap() {
        for (String operation : faces.soap()) {
            String rest = faces.restOf(operation);
            if (rest.startsWith("GET ") && faces.isList(operation) && !rest.startsWith(RECORDS)) {
                for (Role role : Role.values()) {
                    silent(operation + " for our " + role, soap(ours.get(role), operation, ABSENT), foreign);
                    silent(operation + " for their " + role, soap(theirs.get(role), operation, ABSENT), own);
                }
            }
        }
        assertThat(soap(ours.get(Role.ADMINISTRATOR), "getDronesList", ABSENT))
                .contains(own.drone().id())
                .doesNotContain(foreign.drone().id());
        assertThat(wrong).isEmpty();
    }

    /** What one typed oneself stands there, be it foreign or absent. */
    @Test
    void showsRecordsOfOtherOrganisationsOnlyToThoseWhoRunTheServer() {
        for (String form : List.of(RECORDS, RECORDS + "/file")) {
            for (Role role : List.of(Role.SUPERVISOR, Role.ADMINISTRATOR)) {
                theirs.get(role).http().post("/api/v1/zones", "{}");
                ours.get(role).http().post("/api/v1/zones", "{}");
                String seenByUs = rest(ours.get(role), form, ABSENT).raw().body();
                String seenByThem = rest(theirs.get(role), form, ABSENT).raw().body();
                assertThat(seenByThem).contains(foreign.word() + "-" + role).doesNotContain(own.word() + "-");
                assertThat(seenByUs).contains(own.word() + "-" + role);
                assertThat(seenByUs.contains(foreign.word() + "-" + role))
                        .as(form + role)
                        .isEqualTo(role == Role.ADMINISTRATOR);
            }
        }
    }

    @Test
    void answersOwnThingsAsTheRoleMayAndForeignOnesAsAbsentOnesThroughSoap() {
        RightsTable table = RightsTable.below("REST");
        int cells = 0;
        for (String operation : faces.soap()) {
            String rest = faces.restOf(operation);
            String kind = kind(rest);
            if (foreign.thing(kind).isEmpty() || faces.isList(operation)) {
                continue;
            }
            for (Role role : Role.values()) {
                if (isTried(rest)) {
                    boolean promised = table.promises(rest, Caller.valueOf(role.name()));
                    judgeSoap(operation + " for " + role, promised, soap(ours.get(role), operation, ownThing(rest)));
                    cells++;
                }
                if (role != Role.ADMINISTRATOR || !isTakingBack(rest)) {
                    alikeInSoap(ours.get(role), operation, foreign.thing(kind).orElseThrow());
                }
                cells += 2;
            }
        }
        assertThat(wrong).isEmpty();
        assertThat(cells).isGreaterThan(800);
    }

    @Test
    void answersForeignAsAbsentThroughTheStream() {
        for (Role role : Set.of(Role.VIEWER, Role.OPERATOR, Role.SUPERVISOR, Role.ADMINISTRATOR)) {
            try (RecordingStreamClient stream =
                    RecordingStreamClient.withKey(house, ours.get(role).key())) {
                for (String about : List.of(
                        "\"command\",\"command\":{\"type\":\"land\"}",
                        "\"control\",\"action\":\"take\"",
                        "\"steer\",\"velocity\":{\"forward\":1}",
                        "\"letGo\"",
                        "\"positions\",\"follow\":\"fnosuchfollow\"")) {
                    String there = said(stream, about, foreign.drone().id());
                    String absent = said(stream, about, ABSENT);
                    if (!there.equals(absent)) {
                        wrong.add("stream for " + role + ": " + there + " / " + absent);
                    }
                }
            }
        }
        assertThat(wrong).isEmpty();
    }

    @Test
    void answersForeignAsAbsentWhereBodiesNameThings() {
        TestHttpClient root = own.administrator().http();
        String drone = own.drone().id();
        Map<String, String> bodies = new HashMap<>();
        bodies.put(
                "POST /api/v1/commands drones",
                "{\"drones\":[\"%s\"],\"command\":{\"type\":\"land\"},\"id\":\"one-and-same\"}");
        bodies.put("POST /api/v1/dtls-keys drones", "{\"drone\":\"%s\"}");
        bodies.put("POST /api/v1/fleets drones", "{\"name\":\"x\",\"drones\":[\"%s\"]}");
        bodies.put("POST /api/v1/groups users", "{\"name\":\"x\",\"members\":[\"%s\"]}");
        bodies.put("POST /api/v1/grants users", "{\"user\":\"%s\",\"all\":true,\"operations\":[\"view\"]}");
        bodies.put("POST /api/v1/grants groups", "{\"group\":\"%s\",\"all\":true,\"operations\":[\"view\"]}");
        bodies.put(
                "POST /api/v1/grants fleets",
                "{\"user\":\"" + own.administrator().name() + "\",\"fleet\":\"%s\",\"operations\":[\"view\"]}");
        bodies.put(
                "POST /api/v1/grants drones",
                "{\"user\":\"" + own.administrator().name() + "\",\"drones\":[\"%s\"],\"operations\":[\"view\"]}");
        bodies.put("POST /api/v1/drones/" + drone + "/control/hand-over users", "{\"user\":\"%s\"}");
        String zone = "{\"type\":\"Feature\",\"geometry\":{\"type\":\"Point\",\"coordinates\":[10,60]},\"properties\":"
                + "{\"name\":\"x\",\"kind\":\"exclusion\",\"radius\":50,";
        bodies.put("POST /api/v1/zones users", zone + "\"user\":\"%s\"}}");
        bodies.put("POST /api/v1/zones drones", zone + "\"drone\":\"%s\"}}");
        bodies.forEach((what, body) -> {
            String[] words = what.split(" ");
            String thing = foreign.thing(words[2]).orElseThrow();
            TestHttpClient.Answer there = root.post(words[1], String.format(body, thing));
            TestHttpClient.Answer absent = root.post(words[1], String.format(body, ABSENT));
            if (there.status() == 201 || !isSame(there, thing, absent)) {
                wrong.add(
                        what + ": " + there.raw().body() + " / " + absent.raw().body());
            }
        });
        assertThat(wrong).isEmpty();
    }

    @Test
    void tellsEachOrganisationOnTheStreamOfItsOwnThingsOnly() {
        try (RecordingStreamClient ourStream = RecordingStreamClient.withKey(
                        house, ours.get(Role.VIEWER).key());
                RecordingStreamClient theirStream = RecordingStreamClient.withKey(
                        house, theirs.get(Role.VIEWER).key())) {
            for (RecordingStreamClient stream : List.of(ourStream, theirStream)) {
                stream.await(message -> isType(message, "drones"));
            }
            for (OrganisationFixture estate : List.of(own, foreign)) {
                TestHttpClient http = estate.administrator().http();
                http.post("/api/v1/drones/" + estate.drone().id() + "/commands", "{\"type\":\"arm\"}");
                http.post("/api/v1/drones/" + estate.drone().id() + "/control/take", "");
                put(http, "/api/v1/zones/" + estate.thing("zones").orElseThrow(), "{}");
                estate.fresh("zones");
                http.send("/api/v1/drones/" + estate.drone().id() + "/control", HttpRequest.Builder::DELETE);
            }
            heardOnly(ourStream, own, foreign);
            heardOnly(theirStream, foreign, own);
        }
    }

    private static void heardOnly(RecordingStreamClient stream, OrganisationFixture mine, OrganisationFixture other) {
        for (String type : List.of("drone", "command", "control", "zone")) {
            stream.await(message -> isType(message, type));
        }
        stream.await(message -> isType(message, "control")
                && message.path("control").path("state").asString().equals("free"));
        assertThat(stream.heard().toString())
                .contains(mine.drone().id(), mine.word() + "-root")
                .doesNotContain(other.drone().id(), other.word() + "-");
    }

    private static String said(RecordingStreamClient stream, String about, String drone) {
        String id = drone + about.hashCode();
        stream.send("{\"requestId\":\"" + id + "\",\"drone\":\"" + drone + "\",\"type\":" + about + "}");
        return stream.await(message -> message.path("requestId").asString("").equals(id))
                .toString()
                .replace(id, "")
                .replace(drone, ABSENT);
    }

    private static boolean isType(JsonNode message, String type) {
        return message.path("type").asString().equals(type);
    }
}
