package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.http.HttpRequest;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronemap.cognitive.operation.run.RunState;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.lease.Lease;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.operation.JournalEntry;
import org.dronemap.core.operation.JournalReplay;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.ws.testserver.ConditionWait;
import org.dronemap.ws.testserver.ImmediateCopter;
import org.dronemap.ws.testserver.OrganisationMember;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.SoapClient;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;

/** Plans that the cloud has several drones fly. */
class RunsTest {
    private static final String PATH = "/api/v1/runs";
    private static final double LATITUDE = 47.3977;
    private static final double LONGITUDE = 8.5456;

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestServer house = tenant.server();
    private String key;
    private TestHttpClient operator;
    private ImmediateCopter falcon;
    private ImmediateCopter heron;

    @BeforeEach
    void open() {
        key = tenant.key(Role.OPERATOR);
        operator = new TestHttpClient(house, key);
        falcon = copter("Falcon", LONGITUDE);
        heron = copter("Heron", LONGITUDE + 0.0008);
    }

    private ImmediateCopter copter(String name, double longitude) {
        return tenant.copter(name, new Geodetic(LATITUDE, longitude)).wellHeard(house.cloud());
    }

    private static String waypoint(int number) {
        return "{\"latitude\":" + (LATITUDE + 0.0008 + 0.0002 * (number % 3)) + ",\"longitude\":"
                + (LONGITUDE + 0.0003 * number) + ",\"altitude\":30}";
    }

    private String planned() {
        List<String> waypoints = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
            waypoints.add(waypoint(i));
        }
        TestHttpClient.Answer asked = operator.post(
                "/api/v1/plans",
                "{\"drones\":[\"" + falcon.id() + "\",\"" + heron.id() + "\"],\"seconds\":0.1,\"waypoints\":["
                        + String.join(",", waypoints) + "]}");
        String id = asked.text("id");
        ConditionWait.until(
                "the plan is finished",
                () -> Optional.of(operator.get("/api/v1/plans/" + id))
                        .filter(plan -> plan.text("state").equals("finished")));
        return id;
    }

    private String start(String members) {
        TestHttpClient.Answer started = operator.post(PATH, "{\"plan\":\"" + planned() + "\"" + members + "}");
        assertThat(started.status()).as(started.raw().body()).isEqualTo(201);
        String id = started.text("id");
        assertThat(started.raw().headers().firstValue("Location")).hasValue(PATH + "/" + id);
        return id;
    }

    private JsonNode run(String id) {
        return operator.get(PATH + "/" + id).json();
    }

    private boolean isHeldByARun(ImmediateCopter copter) {
        Lease tenure =
                house.cloud().controls().control(new DroneId(copter.id())).tenure();
        return tenure != null && tenure.holder().words().startsWith("The mission run");
    }

    private static TestHttpClient.Answer patch(TestHttpClient http, String path, String body) {
        return http.send(
                path,
                request -> request.header("Content-Type", "application/json")
                        .method("PATCH", HttpRequest.BodyPublishers.ofString(body)));
    }

    private static String detail(TestHttpClient.Answer answer) {
        return answer.status() + " " + answer.text("field") + " " + answer.text("detail");
    }

    @Test
    void takeControlOfTheDronesOfAPlanAndSayHowItStandsWithEach() {
        String id = start(",\"name\":\"roofs\",\"mode\":\"askFirst\",\"onCloudLoss\":\"rtl\"");

        JsonNode run = run(id);
        assertThat(run.path("name").asString()).isEqualTo("roofs");
        assertThat(run.path("mode").asString()).isEqualTo("askFirst");
        assertThat(run.path("onCloudLoss").asString()).isEqualTo("rtl");
        assertThat(run.path("counts").path("waypoints").asInt()).isEqualTo(4);
        assertThat(run.path("drones").size()).isEqualTo(2);
        assertThat(run.path("waypoints").path(0).path("altitudeAmsl").asDouble())
                .isEqualTo(518);
        assertThat(isHeldByARun(falcon)).isTrue();
        assertThat(isHeldByARun(heron)).isTrue();
        assertThat(operator.get(PATH).json().path("runs").path(0).path("id").asString())
                .isEqualTo(id);
    }

    @Test
    void takeOverWhatTheirOwnUserHasInHand() {
        String plan = planned();
        assertThat(operator.post("/api/v1/drones/" + falcon.id() + "/control/take", "")
                        .status())
                .isEqualTo(200);

        TestHttpClient.Answer started = operator.post(PATH, "{\"plan\":\"" + plan + "\"}");

        assertThat(started.status()).as(started.raw().body()).isEqualTo(201);
        assertThat(isHeldByARun(falcon)).isTrue();
    }

    @Test
    void takeADroneBackFromThePilotAtTheVehicleWhenTheyAreTold() {
        String run = PATH + "/" + start("");
        DroneId taken = new DroneId(falcon.id());
        assertThat(detail(operator.post(run + "/drones/" + taken.value() + "/resume", "")))
                .startsWith("409 ");
        house.cloud().controls().apply(taken, new LeaseEvent.PilotActed("changed the mode to LOITER"));
        ConditionWait.until(
                "the pilot has it",
                () -> Optional.of(stage(run, taken)).filter(List.of("left", "suspended")::contains));
        assertThat(isHeldByARun(falcon)).isFalse();

        assertThat(operator.post(run + "/drones/" + taken.value() + "/resume", "")
                        .status())
                .isEqualTo(200);

        ConditionWait.until(
                "the run has it again", () -> Optional.of(isHeldByARun(falcon)).filter(Boolean::booleanValue));
    }

    private String stage(String run, DroneId drone) {
        for (JsonNode one : operator.get(run).json().path("drones")) {
            if (one.path("id").asString().equals(drone.value())) {
                return one.path("stage").asString();
            }
        }
        return "unknown";
    }

    @Test
    void doNotBeginWhileSomebodyElseHasOneOfTheDrones() {
        String plan = planned();
        TestHttpClient another = tenant.http(Role.OPERATOR);
        another.post("/api/v1/drones/" + heron.id() + "/control/take", "");

        TestHttpClient.Answer refused = operator.post(PATH, "{\"plan\":\"" + plan + "\"}");

        assertThat(detail(refused)).startsWith("409 ").contains("has had control of it since");
        assertThat(refused.text("code")).isEqualTo("control-held");
        assertThat(refused.json().path("parameters").path("holder").isString()).isTrue();
        assertThat(isHeldByARun(falcon)).isFalse();
        assertThat(operator.get(PATH).json().path("runs").size()).isZero();
    }

    @Test
    void sayWhichMemberOfARequestCannotBeTaken() {
        String id = start("");
        String run = PATH + "/" + id;
        assertThat(detail(operator.post(PATH, "{}"))).startsWith("422 plan ");
        assertThat(detail(operator.post(PATH, "{\"plan\":\"x\",\"mode\":\"bold\"}")))
                .startsWith("422 mode ");
        assertThat(detail(operator.post(PATH, "{\"plan\":\"nosuchplan\"}"))).startsWith("404 ");
        assertThat(detail(operator.post(run + "/waypoints", "{\"waypoints\":[]}")))
                .startsWith("422 waypoints ");
        assertThat(detail(operator.post(run + "/waypoints", "{\"waypoints\":[{\"latitude\":91,\"longitude\":8}]}")))
                .startsWith("422 waypoints[0].latitude ");
        assertThat(detail(operator.post(
                        run + "/waypoints",
                        "{\"waypoints\":[{\"id\":\"1\",\"latitude\":47.4,\"longitude\":8.5,\"altitude\":20}]}")))
                .startsWith("422 waypoints[0].id There is a waypoint “1” in this run already.");
        assertThat(detail(patch(operator, run + "/waypoints/1", "{\"altitude\":90000}")))
                .startsWith("422 altitude ");
        assertThat(detail(patch(operator, run + "/waypoints/1", "{}"))).startsWith("422 latitude ");
        assertThat(detail(operator.post(run + "/barriers", "{\"type\":\"Feature\"}")))
                .startsWith("422 geometry ");
        assertThat(detail(operator.post(run + "/drones", "{}"))).startsWith("422 drone ");
        assertThat(detail(operator.post(run + "/drones/nobody/resume", ""))).startsWith("404 ");
        assertThat(detail(operator.post(run + "/answers/first", "{\"accept\":true}")))
                .startsWith("422 proposal ");
        assertThat(detail(operator.post(run + "/answers/1", "{}"))).startsWith("422 accept ");
        assertThat(detail(operator.get(run + "/journal?from=-1"))).startsWith("422 from ");
    }

    @Test
    void planRoundZonesThatComeWhileTheyAreFlown() {
        String id = start("");
        String zone = "{\"type\":\"Feature\",\"geometry\":{\"type\":\"Point\",\"coordinates\":[" + LONGITUDE + ","
                + (LATITUDE + 0.003) + "]},\"properties\":{\"name\":\"Crane\",\"radius\":20}}";
        tenant.http(Role.SUPERVISOR).post("/api/v1/zones", zone);
        ConditionWait.until(
                "the run has heard of it",
                () -> Optional.of(run(id).toString())
                        .filter(run -> run.contains("added the no-fly zone “Crane”, which drones keep to")));
        assertThat(run(id).path("barriers").findValuesAsString("name")).containsExactly("Crane");
    }

    @Test
    void areThereForTheirOrganisationAlone() {
        String id = start("");
        OrganisationId others = new OrganisationId("others");
        TestHttpClient supervisor = tenant.http(Role.SUPERVISOR);
        TestHttpClient stranger =
                house.member(others, tenant.unique("stranger"), Role.SUPERVISOR).http();

        assertThat(supervisor.get(PATH + "/" + id).status()).isEqualTo(200);
        assertThat(stranger.get(PATH + "/" + id).status()).isEqualTo(404);
        assertThat(stranger.post(PATH + "/" + id + "/stop", "").status()).isEqualTo(404);
        assertThat(stranger.get(PATH + "/" + id + "/journal").status()).isEqualTo(404);
        assertThat(stranger.get(PATH).json().path("runs").size()).isZero();
    }

    @Test
    void keepAJournalThatIsDecidedOnAgainToTheLetter() {
        String id = start("");
        operator.post(PATH + "/" + id + "/waypoints", "{\"waypoints\":[" + waypoint(5) + "]}");

        JsonNode journal = operator.get(PATH + "/" + id + "/journal").json();
        assertThat(journal.path("entries").path(0).path("number").asInt()).isZero();
        assertThat(journal.path("entries")
                        .path(0)
                        .path("input")
                        .path("id")
                        .path("value")
                        .asString())
                .isEqualTo(id);
        assertThat(journal.path("entries").path(0).path("decision").isNull()).isTrue();
        JsonNode replay = operator.get(PATH + "/" + id + "/journal/replay").json();
        assertThat(replay.path("same").asBoolean()).as(replay.toString()).isTrue();
        assertThat(replay.path("entries").asInt()).isPositive();
    }

    @Test
    void goTheSameWayThroughSoap() {
        SoapClient soap = SoapClient.withKey(house, key);
        assertThatThrownBy(() -> soap.call("startRun", "plan", "nosuchplan")).hasMessageContaining("There is no plan");

        SoapClient.Answer started =
                soap.call("startRun", "plan", planned(), "mode", "askFirst", "onCloudLoss", "rtl", "name", "roofs");
        String run = started.text("id");

        assertThat(started.texts("drones.item.id")).containsExactly(falcon.id(), heron.id());
        assertThat(soap.call("listRuns").texts("runs.item.id")).containsExactly(run);
        assertThat(soap.call("getRun", "runId", run).texts("waypoints.item.id")).containsExactly("1", "2", "3", "4");
        assertThatThrownBy(() -> soap.call(
                        "addRunWaypoints",
                        "runId",
                        run,
                        "waypoints",
                        List.of(Map.of("latitude", 95.0, "longitude", LONGITUDE, "altitude", 30.0))))
                .hasMessageContaining("waypoints[0].latitude");
        assertThatThrownBy(() -> soap.call("answerRun", "runId", run, "accept", true))
                .hasMessageContaining("proposal");
        assertThatThrownBy(() -> soap.call("resumeRunDrone", "runId", run, "drone", "nobody"))
                .hasMessageContaining("There is no drone");
        assertThat(soap.call("pauseRun", "runId", run).text("state")).isEqualTo("paused");
        assertThatThrownBy(() -> soap.call("pauseRun", "runId", run)).hasMessageContaining("paused already");
        assertThat(soap.call("continueRun", "runId", run).text("state")).isEqualTo("running");
        assertThatThrownBy(() -> soap.call("continueRun", "runId", run)).hasMessageContaining("is not paused");
        assertThat(soap.call("stopRun", "runId", run).text("id")).isEqualTo(run);
    }

    @Test
    void areToldOnTheStreamToWhoMaySeeThem() {
        OrganisationMember stranger =
                house.member(new OrganisationId("others"), tenant.unique("stranger"), Role.SUPERVISOR);
        try (RecordingStreamClient mine = RecordingStreamClient.withKey(house, key);
                RecordingStreamClient theirs = RecordingStreamClient.withKey(house, stranger.key())) {
            mine.await(message -> isOf(message, "drones"));
            theirs.await(message -> isOf(message, "drones"));

            String id = start("");

            JsonNode told = mine.await(message -> isOf(message, "run")).path("run");
            assertThat(told.path("id").asString()).isEqualTo(id);
            try (RecordingStreamClient later = RecordingStreamClient.withKey(house, key)) {
                assertThat(later.await(message -> isOf(message, "run"))
                                .path("run")
                                .path("id")
                                .asString())
                        .isEqualTo(id);
            }
            theirs.send("{\"type\":\"ping\"}");
            theirs.await(message -> {
                assertThat(isOf(message, "run")).isFalse();
                return isOf(message, "pong");
            });
        }
    }

    private static boolean isOf(JsonNode message, String type) {
        return message.path("type").asString().equals(type);
    }

    private static List<String> kinds(ImmediateCopter copter) {
        return copter.performed().stream()
                .map(command -> command.getClass().getSimpleName())
                .toList();
    }

    /** Its whole mission, once it was started, and down. */
    private static void fly(ImmediateCopter copter) {
        ConditionWait.until(
                "it is started", () -> Optional.of(kinds(copter)).filter(all -> all.contains("StartMission")));
        int items = copter.performed().stream()
                .filter(Command.UploadMission.class::isInstance)
                .map(Command.UploadMission.class::cast)
                .findFirst()
                .orElseThrow()
                .mission()
                .items()
                .size();
        for (int item = 0; item < items; item++) {
            copter.reaches(item);
        }
        copter.isOnGround();
    }

    private JsonNode over(String id) {
        return ConditionWait.until(
                "the run is over",
                () -> Optional.of(run(id))
                        .filter(run -> run.path("state").asString().equals("over")));
    }

    @Test
    void flyAPlanToItsEndAndVouchForWhatTheyDecided() {
        String id = start("");
        fly(falcon);
        fly(heron);

        JsonNode run = over(id);

        assertThat(run.path("counts").path("visited").asInt())
                .as(run.toString())
                .isEqualTo(4);
        assertThat(run.path("end").asString()).isEqualTo("The run is over: all 4 waypoints visited.");
        assertThat(kinds(falcon))
                .containsExactly("UploadMission", "SetCloudLossAction", "SetReturnHeight", "Arm", "StartMission");
        assertThat(isHeldByARun(falcon)).isFalse();
        assertThat(operator.post(PATH + "/" + id + "/stop", "").status()).isEqualTo(409);
        JsonNode replay = operator.get(PATH + "/" + id + "/journal/replay").json();
        assertThat(replay.path("same").asBoolean()).as(replay.toString()).isTrue();
        assertThat(replay.path("entries").asLong())
                .isEqualTo(run.path("journal").asLong() + 1)
                .isGreaterThan(10);
    }

    @Test
    void noticeASingleLetterOfAJournalThatWasChanged() {
        String id = start("");
        fly(falcon);
        fly(heron);
        over(id);
        List<JournalEntry> journal = new ArrayList<>(house.runs().operations().journal(new OperationId(id), 0, 10_000));
        JournalEntry last = journal.get(journal.size() - 1);
        String other = last.decision().endsWith("0\"}") ? "1\"}" : "0\"}";
        String changed = last.decision().substring(0, last.decision().length() - 3) + other;
        journal.set(journal.size() - 1, new JournalEntry(last.number(), last.at(), last.input(), changed));

        JournalReplay<RunState, RunInput> replay =
                new JournalReplay<>(house.runs().kind());
        replay.replay(journal);

        assertThat(replay.difference()).contains(new JournalReplay.Difference(last.number(), changed, last.decision()));
    }
}
