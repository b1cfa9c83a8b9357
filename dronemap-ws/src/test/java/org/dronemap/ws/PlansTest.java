package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.http.HttpRequest;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.Command;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.ws.testserver.ConditionWait;
import org.dronemap.ws.testserver.ImmediateCopter;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.SoapClient;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;

/** Waypoints shared out among several drones: asked for, looked at, accepted, started. */
class PlansTest {
    private static final String PATH = "/api/v1/plans";
    private static final double LATITUDE = 47.3977;
    private static final double LONGITUDE = 8.5456;
    private static final int WAYPOINTS = 6;

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

    /** So many waypoints in a row to the north of the drones, 30 m above home. */
    private static String waypoints(int count) {
        return IntStream.range(0, count)
                .mapToObj(i -> waypoint(LATITUDE + 0.0008 + 0.0002 * (i % 3), LONGITUDE + 0.0003 * i))
                .collect(Collectors.joining(",", "\"waypoints\":[", "]"));
    }

    private static String waypoint(double latitude, double longitude) {
        return "{\"latitude\":" + latitude + ",\"longitude\":" + longitude + ",\"altitude\":30,\"holdSeconds\":2}";
    }

    private String drones() {
        return "\"drones\":[\"" + falcon.id() + "\",\"" + heron.id() + "\"]";
    }

    private String ask(String members) {
        TestHttpClient.Answer answer = operator.post(PATH, "{" + drones() + "," + members + "}");
        assertThat(answer.status()).as(answer.raw().body()).isEqualTo(202);
        String id = answer.text("id");
        assertThat(answer.raw().headers().firstValue("Location")).hasValue(PATH + "/" + id);
        return id;
    }

    private JsonNode finished(String id) {
        return await(id, "finished");
    }

    private JsonNode await(String id, String state) {
        return ConditionWait.until(
                "the plan is " + state,
                () -> Optional.of(operator.get(PATH + "/" + id).json())
                        .filter(plan -> plan.path("state").asString("").equals(state)));
    }

    private static List<MissionItem.Waypoint> flown(ImmediateCopter copter) {
        return copter.performed().stream()
                .filter(Command.UploadMission.class::isInstance)
                .map(Command.UploadMission.class::cast)
                .flatMap(upload -> upload.mission().items().stream())
                .filter(MissionItem.Waypoint.class::isInstance)
                .map(MissionItem.Waypoint.class::cast)
                .toList();
    }

    private static List<String> kinds(ImmediateCopter copter) {
        return copter.performed().stream()
                .map(command -> command.getClass().getSimpleName())
                .toList();
    }

    private static List<String> stages(JsonNode plan) {
        List<String> stages = new ArrayList<>();
        plan.path("launch")
                .path("drones")
                .forEach(one -> stages.add(one.path("stage").asString("")));
        return stages;
    }

    @Test
    void shareWaypointsOutAndBringEachDroneItsPart() {
        String id = ask(waypoints(WAYPOINTS) + ",\"seconds\":0.2");
        JsonNode plan = finished(id);

        List<String> visited = new ArrayList<>();
        plan.path("result")
                .path("tours")
                .forEach(tour -> tour.path("stops")
                        .forEach(stop -> visited.add(stop.path("waypoint").asString(""))));
        assertThat(visited).containsExactlyInAnyOrder("1", "2", "3", "4", "5", "6");
        assertThat(plan.path("result").path("tours").size()).isEqualTo(2);
        assertThat(plan.path("result").path("faults").size()).isZero();
        assertThat(plan.path("progress").path("gap").asDouble()).isBetween(0.0, 1.0);
        assertThat(plan.path("improvements").size()).isPositive();

        TestHttpClient.Answer accepted = operator.post(PATH + "/" + id + "/accept?wait=20", "{}");
        assertThat(accepted.status()).as(accepted.raw().body()).isEqualTo(200);
        assertThat(stages(accepted.json())).containsExactly("uploaded", "uploaded");
        assertThat(kinds(falcon)).containsExactly("UploadMission");
        List<MissionItem.Waypoint> items = List.of(falcon, heron).stream()
                .flatMap(copter -> flown(copter).stream())
                .toList();
        // Homes are at 488 m.
        assertThat(items)
                .filteredOn(item -> item.holdSeconds() >= 2)
                .hasSize(WAYPOINTS)
                .extracting(MissionItem.Waypoint::altitude)
                .containsOnly(new Altitude(518, Altitude.Reference.AMSL));
    }

    @Test
    void startTheDronesOnceAllHaveTheirMissions() {
        String id = ask(waypoints(WAYPOINTS) + ",\"seconds\":0.1");
        finished(id);

        TestHttpClient.Answer accepted = operator.post(PATH + "/" + id + "/accept?wait=30", "{\"start\":true}");
        assertThat(stages(accepted.json())).as(accepted.raw().body()).containsExactly("started", "started");
        assertThat(kinds(falcon)).containsExactly("UploadMission", "SetCloudLossAction", "Arm", "StartMission");
        assertThat(kinds(heron)).containsExactly("UploadMission", "SetCloudLossAction", "Arm", "StartMission");

        assertThat(operator.post(PATH + "/" + id + "/accept", "{}").text("detail"))
                .contains("is in the air; plan again");
    }

    @Test
    void startNobodyElseOnceTheStartIsStopped() {
        ImmediateCopter kestrel = copter("Kestrel", LONGITUDE + 0.00004);
        TestHttpClient.Answer asked = operator.post(
                PATH,
                "{\"drones\":[\"" + falcon.id() + "\",\"" + kestrel.id() + "\"],\"seconds\":0.1,"
                        + "\"objective\":{\"kind\":\"earliestEnd\",\"everyDrone\":true},\"waypoints\":["
                        + waypoint(LATITUDE + 0.01, LONGITUDE) + "," + waypoint(LATITUDE + 0.01, LONGITUDE + 0.002)
                        + "]}");
        String id = asked.text("id");
        finished(id);
        operator.post(PATH + "/" + id + "/accept", "{\"start\":true}");
        ConditionWait.until(
                "one waits while the other one flies",
                () -> Optional.of(stages(operator.get(PATH + "/" + id).json()))
                        .filter(stages -> stages.contains("waiting") && stages.contains("started")));
        assertThat(delete(operator, id)).isEqualTo(409);

        assertThat(operator.post(PATH + "/" + id + "/stop", "").status()).isEqualTo(200);
        JsonNode plan = ConditionWait.until(
                "nothing is under way",
                () -> Optional.of(operator.get(PATH + "/" + id).json())
                        .filter(one -> !one.path("launch").path("underWay").asBoolean(true)));
        assertThat(stages(plan)).containsExactlyInAnyOrder("started", "heldBack");
        assertThat(plan.toString()).contains("the start was stopped");
        assertThat(List.of(kinds(falcon), kinds(kestrel))).contains(List.of("UploadMission"));
        assertThat(operator.post(PATH + "/" + id + "/stop", "").text("detail"))
                .isEqualTo("Nobody of this plan waits for a start.");
    }

    @Test
    void startNobodyWhileOneDroneHasNoMission() {
        heron.cannot(Command.UploadMission.class);
        String id = ask(waypoints(WAYPOINTS) + ",\"seconds\":0.1");
        finished(id);

        TestHttpClient.Answer accepted = operator.post(PATH + "/" + id + "/accept?wait=30", "{\"start\":true}");
        assertThat(stages(accepted.json())).containsExactlyInAnyOrder("heldBack", "failed");
        assertThat(accepted.raw().body()).contains("It does not want to.");
        assertThat(kinds(falcon)).containsExactly("UploadMission");
    }

    @Test
    void leadRoundTheZonesThatBindTheDrones() {
        TestHttpClient supervisor = tenant.http(Role.SUPERVISOR);
        String zone = "{\"type\":\"Feature\",\"geometry\":{\"type\":\"Point\",\"coordinates\":[" + LONGITUDE + ","
                + (LATITUDE + 0.001) + "]},\"properties\":{\"name\":\"Crane\",\"kind\":\"exclusion\",\"radius\":40}}";
        assertThat(supervisor.post("/api/v1/zones", zone).status()).isEqualTo(201);
        String places = "\"waypoints\":[" + waypoint(LATITUDE + 0.002, LONGITUDE) + ","
                + waypoint(LATITUDE + 0.001, LONGITUDE) + "]";
        TestHttpClient.Answer asked =
                operator.post(PATH, "{\"drones\":[\"" + falcon.id() + "\"],\"seconds\":0.1," + places + "}");
        JsonNode plan = finished(asked.text("id")).path("result");

        assertThat(plan.path("unserved").path(0).path("waypoint").asString("")).isEqualTo("2");
        assertThat(plan.path("unserved").path(0).path("why").asString("")).contains("the no-fly zone “Crane”");
        assertThat(plan.path("unserved").path(0).path("place").path("latitude").asDouble())
                .isEqualTo(LATITUDE + 0.001);
        assertThat(plan.path("tours").path(0).path("distance").asDouble()).isGreaterThan(2 * 0.002 * 111_000 + 5);
        TestHttpClient.Answer accepted = operator.post(PATH + "/" + asked.text("id") + "/accept?wait=20", "{}");
        assertThat(stages(accepted.json())).as(accepted.raw().body()).containsExactly("uploaded");
    }

    @Test
    void sayWhichFactOfWhichDroneIsMissing() {
        ScriptedVehicle stranger = tenant.vehicle();
        TestHttpClient.Answer answer =
                operator.post(PATH, "{\"drones\":[\"" + stranger.id() + "\"]," + waypoints(1) + "}");

        assertThat(answer.status()).isEqualTo(409);
        assertThat(answer.text("detail")).isEqualTo("Where the home of “" + stranger.name() + "” is, is not known.");
    }

    @Test
    void sayWhatIsWrongWithWhatWasAsked() {
        assertThat(field("{" + waypoints(1) + "}")).isEqualTo("drones");
        assertThat(detail("{" + waypoints(1) + "}")).contains("a list of 1 to 100 ids of drones, or upTo instead");
        assertThat(field("{" + drones() + ",\"upTo\":2," + waypoints(1) + "}")).isEqualTo("upTo");
        assertThat(detail("{" + drones() + ",\"upTo\":2," + waypoints(1) + "}"))
                .isEqualTo("A plan is either for drones that are named (drones) or for some of the pool (upTo), not for"
                        + " both.");
        assertThat(field("{\"upTo\":0," + waypoints(1) + "}")).isEqualTo("upTo");
        assertThat(field("{\"upTo\":101," + waypoints(1) + "}")).isEqualTo("upTo");
        assertThat(field("{" + drones() + "}")).isEqualTo("waypoints");
        assertThat(field("{" + drones() + ",\"waypoints\":[{\"latitude\":95,\"longitude\":8,\"altitude\":20}]}"))
                .isEqualTo("waypoints[0].latitude");
        assertThat(field("{" + drones() + ",\"waypoints\":[{\"latitude\":47.4,\"longitude\":8.5}]}"))
                .isEqualTo("waypoints[0].altitude");
        assertThat(field("{" + drones() + "," + waypoints(1) + ",\"seconds\":61}"))
                .isEqualTo("seconds");
        assertThat(field("{" + drones() + "," + waypoints(1) + ",\"objective\":{\"kind\":\"best\"}}"))
                .isEqualTo("objective.kind");
        assertThat(field("{" + drones() + "," + waypoints(1) + ",\"wind\":{\"speed\":5}}"))
                .isEqualTo("wind.from");
        assertThat(field("{" + drones() + ",\"waypoints\":[{\"tasks\":[{\"type\":\"dance\"}]}]}"))
                .isEqualTo("waypoints[0].tasks[0].type");
        assertThat(field("{" + drones() + ",\"waypoints\":[{\"tasks\":[{\"type\":\"photo\",\"seconds\":3}]}]}"))
                .isEqualTo("waypoints[0].tasks[0].seconds");
        assertThat(field("{" + drones() + ",\"waypoints\":[{\"latitude\":48.4,\"longitude\":18.5,\"altitude\":20}]}"))
                .isEqualTo("waypoints");
    }

    private String detail(String body) {
        return operator.post(PATH, body).text("detail");
    }

    private String field(String body) {
        TestHttpClient.Answer answer = operator.post(PATH, body);
        assertThat(answer.status()).as(answer.raw().body()).isEqualTo(422);
        return answer.text("field");
    }

    @Test
    void belongToWhoAskedForThem() {
        String id = ask(waypoints(1) + ",\"seconds\":0.1");
        finished(id);
        TestHttpClient other = tenant.http(Role.ADMINISTRATOR);

        TestHttpClient.Answer foreign = other.get(PATH + "/" + id);
        TestHttpClient.Answer absent = other.get(PATH + "/absentabsentabse");
        assertThat(foreign.status()).isEqualTo(404);
        assertThat(foreign.raw().body().replace(id, "absentabsentabse"))
                .isEqualTo(absent.raw().body());
        assertThat(other.post(PATH + "/" + id + "/accept", "{}").status()).isEqualTo(404);
        assertThat(delete(other, id)).isEqualTo(404);
        assertThat(other.get(PATH).json().path("plans").size()).isZero();
        assertThat(operator.get(PATH).json().path("plans").size()).isEqualTo(1);
        TestHttpClient viewer = tenant.http(Role.VIEWER);
        assertThat(viewer.post(PATH, "{}").status()).isEqualTo(403);
        TestHttpClient.Answer absentDrone = operator.post(PATH, "{\"drones\":[\"nosuchdrone\"]," + waypoints(1) + "}");
        assertThat(absentDrone.text("detail")).isEqualTo("There is no drone nosuchdrone.");
    }

    @Test
    void areStartedOnlyByOperators() {
        TestHttpClient planner = tenant.http(Role.PLANNER);
        String id = planner.post(PATH, "{" + drones() + "," + waypoints(2) + ",\"seconds\":0.1}")
                .text("id");
        ConditionWait.until(
                "the plan is finished",
                () -> Optional.of(planner.get(PATH + "/" + id))
                        .filter(one -> one.text("state").equals("finished")));

        assertThat(planner.post(PATH + "/" + id + "/accept", "{\"start\":true}").status())
                .isEqualTo(403);
        TestHttpClient.Answer accepted = planner.post(PATH + "/" + id + "/accept?wait=20", "");
        assertThat(stages(accepted.json())).containsOnly("uploaded");
    }

    @Test
    void areCancelledAndForgottenAndAreNotTooManyAtOnce() {
        List<String> ids = List.of(searching(), searching(), searching());
        TestHttpClient.Answer tooMany = operator.post(PATH, "{" + drones() + "," + waypoints(40) + ",\"seconds\":60}");
        assertThat(tooMany.status()).isEqualTo(409);
        assertThat(tooMany.text("detail")).startsWith("You have 3 plans under way already");
        assertThat(notFinished(ids.get(0))).isEqualTo("plan-not-finished");

        for (String id : ids) {
            assertThat(delete(operator, id)).isEqualTo(204);
            await(id, "cancelled");
            assertThat(notFinished(id)).isEqualTo("plan-without-result");
            assertThat(delete(operator, id)).isEqualTo(204);
            assertThat(delete(operator, id)).isEqualTo(404);
        }
        finished(ask(waypoints(2) + ",\"seconds\":0.1"));
    }

    /** The code that it is told by. */
    private String notFinished(String id) {
        TestHttpClient.Answer refused = operator.post(PATH + "/" + id + "/accept", "{}");
        assertThat(refused.text("detail")).isEqualTo("The plan is not finished.");
        return refused.text("code");
    }

    private String searching() {
        return ask(waypoints(40) + ",\"seconds\":60");
    }

    private static int delete(TestHttpClient http, String id) {
        return http.send(PATH + "/" + id, HttpRequest.Builder::DELETE).status();
    }

    @Test
    void goTheSameWayThroughSoap() {
        SoapClient soap = SoapClient.withKey(house, key);
        List<Map<String, Object>> visits =
                List.of(visit(LATITUDE + 0.0008, LONGITUDE), visit(LATITUDE + 0.0012, LONGITUDE + 0.0008));
        assertThatThrownBy(() -> soap.call(
                        "makePlan", "drones", List.of(falcon.id()), "waypoints", List.of(visit(95.0, LONGITUDE))))
                .hasMessageContaining("waypoints[0].latitude");
        String plan = soap.call(
                        "makePlan", "drones", List.of(falcon.id(), heron.id()), "waypoints", visits, "seconds", 0.1)
                .text("id");
        ConditionWait.until(
                "the plan is finished",
                () -> Optional.of(operator.get(PATH + "/" + plan))
                        .filter(seen -> seen.text("state").equals("finished")));
        assertThat(soap.call("getPlan", "planId", plan).texts("result.tours.item"))
                .isNotEmpty();

        SoapClient.Answer flown = soap.call("acceptPlan", "planId", plan, "start", true);
        assertThat(flown.texts("launch.drones.item.stage")).containsOnly("started");
        assertThat(flown.texts("result.tours.item.stops.item.waypoint")).containsExactlyInAnyOrder("1", "2");
        assertThatThrownBy(() -> soap.call("stopPlan", "planId", plan))
                .hasMessageContaining("Nobody of this plan waits for a start.");
        soap.call("removePlan", "planId", plan);
        assertThatThrownBy(() -> soap.call("getPlan", "planId", plan)).hasMessageContaining("There is no plan");
    }

    private static Map<String, Object> visit(double latitude, double longitude) {
        return Map.of("latitude", latitude, "longitude", longitude, "altitude", 30.0);
    }

    @Test
    void areToldOnTheStreamToWhoAskedForThem() {
        try (RecordingStreamClient mine = RecordingStreamClient.withKey(house, key);
                RecordingStreamClient others = RecordingStreamClient.withKey(house, tenant.key(Role.ADMINISTRATOR))) {
            mine.await(message -> message.path("type").asString().equals("drones"));
            others.await(message -> message.path("type").asString().equals("drones"));
            String id = ask(waypoints(12) + ",\"seconds\":1");
            JsonNode told = mine.await(message -> message.path("type")
                                    .asString()
                                    .equals("plan")
                            && message.path("plan").path("state").asString("").equals("finished"))
                    .path("plan");
            assertThat(told.path("id").asString("")).isEqualTo(id);
            assertThat(told.path("orders").size()).isEqualTo(2);
            delete(operator, id);
            mine.await(message -> message.path("type").asString().equals("planRemoved"));
            others.send("{\"type\":\"ping\"}");
            others.await(message -> {
                assertThat(message.path("type").asString()).doesNotStartWith("plan");
                return message.path("type").asString().equals("pong");
            });
        }
    }
}
