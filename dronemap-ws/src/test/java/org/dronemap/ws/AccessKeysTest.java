package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.http.HttpRequest;
import java.time.Instant;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.dronemap.core.access.KeyRights;
import org.dronemap.core.access.KeyScope;
import org.dronemap.core.access.Permission;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Position;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.core.zone.AltitudeBand;
import org.dronemap.core.zone.FlightBounds;
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
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.JsonNode;

/** How far keys reach, through every face. */
class AccessKeysTest {
    private static final String MISSION =
            "{\"type\":\"uploadMission\",\"items\":[{\"type\":\"waypoint\",\"latitude\":47.4,\"longitude\":8.5,\"altitude\":20}]}";

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestServer house = tenant.server();
    private ScriptedVehicle mine;
    private ScriptedVehicle other;

    @BeforeEach
    void open() {
        mine = tenant.vehicle();
        other = tenant.vehicle();
    }

    @Test
    void showOnlyTheirDronesInListsBroadcastsAndStreams() {
        String key = tenant.key(operatorOf(mine));
        TestHttpClient http = new TestHttpClient(house, key);

        assertThat(http.get("/api/v1/drones").json().path("drones").findValuesAsString("id"))
                .contains(mine.id())
                .doesNotContain(other.id());
        assertThat(SoapClient.withKey(house, key).call("getDronesList").texts("drones.item.id"))
                .containsExactly(mine.id());
        TestHttpClient.Answer sent = http.post(
                "/api/v1/commands",
                "{\"drones\":[\"" + mine.id() + "\",\"" + other.id() + "\"],\"command\":{\"type\":\"land\"}}");
        assertThat(sent.json().path("results").get(1).path("problem").asString())
                .isEqualTo("There is no drone " + other.id() + ".");
        assertThat(sent.json().path("results").get(1).path("name").isNull()).isTrue();
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, key)) {
            JsonNode list =
                    stream.await(message -> message.path("type").asString().equals("drones"));
            assertThat(list.path("drones").size()).isEqualTo(1);
            TestHttpClient all = tenant.http(Role.OPERATOR);
            all.post("/api/v1/drones/" + other.id() + "/commands?wait=10", "{\"type\":\"arm\"}");
            all.post("/api/v1/drones/" + mine.id() + "/commands?wait=10", "{\"type\":\"arm\"}");
            stream.await(
                    message -> message.path("command").path("type").asString().equals("arm")
                            && message.path("command").path("phase").asString().equals("done"));
            assertThat(stream.heard()).noneMatch(message -> message.toString().contains(other.id()));
        }
        assertThat(other.performed()).filteredOn(Command.Arm.class::isInstance).hasSize(1);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "/commands",
                "/fence",
                "/rally-points",
                "/parameters",
                "/parameters/file",
                "/logs",
                "/logs/1/file",
                "/link-security"
            })
    void answerForOtherDronesAsForThoseThatAreNotThere(String below) {
        TestHttpClient http = new TestHttpClient(house, tenant.key(operatorOf(mine)));
        TestHttpClient.Answer foreign = http.get("/api/v1/drones/" + other.id() + below);
        TestHttpClient.Answer absent = http.get("/api/v1/drones/nosuchdrone" + below);
        assertThat(foreign.status()).isEqualTo(404);
        assertThat(foreign.raw().body().replace(other.id(), "nosuchdrone"))
                .isEqualTo(absent.raw().body());
    }

    @Test
    void sendNothingToOtherDrones() {
        String key = tenant.key(operatorOf(mine));

        TestHttpClient.Answer foreign =
                new TestHttpClient(house, key).post("/api/v1/drones/" + other.id() + "/commands", "{\"type\":\"arm\"}");

        assertThat(foreign.status()).isEqualTo(404);
        assertThatThrownBy(() -> SoapClient.withKey(house, key).call("arm", "droneId", other.id()))
                .hasMessage("There is no drone " + other.id() + ".");
        assertThat(other.performed()).isEmpty();
    }

    @Test
    void doNotTellOfCommandsToOtherDrones() {
        TestHttpClient all = tenant.http(Role.OPERATOR);
        String command = all.post("/api/v1/drones/" + other.id() + "/commands?wait=10", "{\"type\":\"arm\"}")
                .text("id");

        assertThat(all.get("/api/v1/commands/" + command).status()).isEqualTo(200);
        assertThat(new TestHttpClient(house, tenant.key(operatorOf(mine)))
                        .get("/api/v1/commands/" + command)
                        .text("detail"))
                .isEqualTo("There is no command " + command + ".");
    }

    @Test
    void doNothingThatConcernsAllDronesWhenTheyAreForSome() {
        KeyScope scope = new KeyScope(Set.of(new DroneId(mine.id())), EnumSet.allOf(Permission.class));
        TestHttpClient http = new TestHttpClient(house, tenant.key(new KeyRights(Role.ADMINISTRATOR, scope, null)));

        for (String path :
                List.of("/api/v1/users", "/api/v1/endpoints", "/api/v1/traffic", "/api/v1/replays", "/metrics")) {
            assertThat(http.get(path).text("detail"))
                    .as(path)
                    .isEqualTo("This access key is for certain drones only, and this concerns all of them.");
        }
        assertThat(http.get("/api/v1/drones/" + mine.id() + "/link-security").status())
                .isEqualTo(200);
    }

    @Test
    void doOnlyTheOperationsThatTheyAreFor() {
        String path = "/api/v1/drones/" + mine.id() + "/commands?wait=10";
        TestHttpClient viewing = new TestHttpClient(house, tenant.key(operator(Permission.VIEW)));
        TestHttpClient planning = new TestHttpClient(house, tenant.key(operator(Permission.PLAN)));
        TestHttpClient commanding = new TestHttpClient(house, tenant.key(operator(Permission.COMMAND)));

        assertThat(viewing.get("/api/v1/drones").status()).isEqualTo(200);
        assertThat(viewing.post(path, "{\"type\":\"arm\"}").text("detail"))
                .isEqualTo("This access key may only view; make one that may more.");
        assertThat(planning.post(path, MISSION).status()).isEqualTo(200);
        assertThat(planning.post(path, "{\"type\":\"arm\"}").text("detail"))
                .isEqualTo("This access key may not command.");
        assertThat(planning.send("/api/v1/drones/" + mine.id() + "/control", HttpRequest.Builder::DELETE)
                        .status())
                .isEqualTo(200);
        assertThat(commanding.post(path, "{\"type\":\"arm\"}").status()).isEqualTo(200);
        assertThat(commanding.post(path, MISSION).text("detail"))
                .isEqualTo("This access key may not change missions, fences or rally points.");
        assertThat(commanding.post("/api/v1/missions", "{}").status()).isEqualTo(403);
    }

    @Test
    void endByThemselvesOnOpenStreamsToo() {
        KeyRights over = new KeyRights(Role.VIEWER, KeyScope.ALL, Instant.now().minusSeconds(1));
        assertThat(new TestHttpClient(house, tenant.key(over))
                        .get("/api/v1/drones")
                        .status())
                .isEqualTo(401);

        KeyRights soon = new KeyRights(Role.VIEWER, KeyScope.ALL, Instant.now().plusSeconds(3));
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, tenant.key(soon))) {
            assertThat(stream.awaitClose()).startsWith("This session has ended");
        }
    }

    @Test
    void makeOthersThatStayWithinThemAndGoWithThem() {
        TestHttpClient user = tenant.http(Role.OPERATOR);
        TestHttpClient.Answer parent = user.post(
                "/api/v1/access-keys",
                "{\"label\":\"parent\",\"operations\":[\"command\"],\"drones\":[\"" + mine.id() + "\"],\"days\":2}");
        TestHttpClient byParent = new TestHttpClient(house, parent.text("key"));

        assertThat(refusal(byParent, "\"role\":\"administrator\"")).contains("who is operator");
        assertThat(refusal(byParent, "\"drones\":[\"" + other.id() + "\"]")).contains("drones other than " + mine.id());
        assertThat(refusal(byParent, "\"operations\":[\"plan\"]")).contains("no more than view, command");
        assertThat(refusal(byParent, "\"days\":3")).contains("cannot last longer");
        TestHttpClient.Answer child =
                byParent.post("/api/v1/access-keys", "{\"label\":\"child\",\"operations\":[\"view\"],\"days\":1}");
        assertThat(child.json().path("drones").get(0).asString()).isEqualTo(mine.id());
        assertThat(child.text("parent")).isEqualTo(parent.text("id"));
        TestHttpClient byChild = new TestHttpClient(house, child.text("key"));
        assertThat(byChild.get("/api/v1/drones/" + mine.id()).status()).isEqualTo(200);
        assertThat(byChild.get("/api/v1/drones/" + other.id()).status()).isEqualTo(404);
        assertThat(byChild.get("/api/v1/access-keys").json().path("accessKeys").size())
                .isEqualTo(1);
        assertThat(remove(byChild, parent.text("id")).status()).isEqualTo(404);

        assertThat(remove(user, parent.text("id")).status()).isEqualTo(204);
        assertThat(byParent.get("/api/v1/drones").status()).isEqualTo(401);
        assertThat(byChild.get("/api/v1/drones").status()).isEqualTo(401);
    }

    @Test
    void flyOnlyInTheirAreaAndHeights() {
        TestHttpClient user = tenant.http(Role.OPERATOR);
        TestHttpClient.Answer made =
                user.post("/api/v1/access-keys", "{\"label\":\"field\"," + circle(500) + ",\"ceiling\":60}");
        TestHttpClient http = new TestHttpClient(house, made.text("key"));
        String path = "/api/v1/drones/" + mine.id() + "/commands?wait=10";

        assertThat(made.json().path("area").path("radius").asDouble()).isEqualTo(500);
        assertThat(made.text("altitudeReference")).isEqualTo("home");
        armed(FlightPhase.ON_GROUND, 0);
        assertThat(http.post(path, "{\"type\":\"takeOff\",\"altitude\":80}").text("detail"))
                .contains("over the ceiling of the bounds of this access key at 60 m above home");
        armed(FlightPhase.IN_AIR, 20);
        assertThat(http.post(path, goTo(47.41, 30)).text("detail"))
                .contains("leaves the bounds of this access key after 500 m");
        flyNowhereElseByOtherFaces(made.text("key"));
        assertThat(mine.performed()).isEmpty();
        assertThat(http.post(path, goTo(47.399, 30)).status()).isEqualTo(200);
        assertThat(http.post(path, "{\"type\":\"returnToLaunch\"}").status()).isEqualTo(200);
        assertThat(user.post(path, goTo(47.41, 30)).status()).isEqualTo(200);
    }

    private void flyNowhereElseByOtherFaces(String key) {
        SoapClient.Answer command = SoapClient.withKey(house, key)
                .call("goto", "droneId", mine.id(), "latitude", 47.41, "longitude", 8.5456, "altitude", 30.0);
        assertThat(command.text("outcome.result") + " by " + command.text("outcome.by"))
                .isEqualTo("refused by gate");
        assertThat(command.text("outcome.reason")).contains("leaves the bounds of this access key after");
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, key)) {
            stream.send("{\"type\":\"command\",\"requestId\":\"r\",\"drone\":\"" + mine.id() + "\",\"command\":"
                    + goTo(47.41, 30) + "}");
            assertThat(stream.await(message ->
                                    message.path("requestId").asString("").equals("r"))
                            .toString())
                    .contains("leaves the bounds of this access key after");
        }
    }

    @Test
    void makeOthersOnlyWithinTheirAreaAndHeights() {
        TestHttpClient user = tenant.http(Role.OPERATOR);
        TestHttpClient byParent = new TestHttpClient(
                house,
                user.post(
                                "/api/v1/access-keys",
                                "{\"label\":\"parent\"," + circle(500) + ",\"floor\":10,\"ceiling\":60}")
                        .text("key"));

        TestHttpClient.Answer wide = byParent.post("/api/v1/access-keys", "{\"label\":\"child\"," + circle(501) + "}");
        assertThat(wide.status()).isEqualTo(422);
        assertThat(wide.text("field")).isEqualTo("area");
        assertThat(wide.text("allowed")).isEqualTo("within the circle of 500 m around 47.397700, 8.545600");
        TestHttpClient.Answer high = byParent.post("/api/v1/access-keys", "{\"label\":\"child\",\"ceiling\":61}");
        assertThat(high.text("field")).isEqualTo("ceiling");
        assertThat(high.text("allowed")).isEqualTo("10 to 60 m above home, as for the key that it is made with");
        assertThat(byParent.post(
                                "/api/v1/access-keys",
                                "{\"label\":\"child\",\"ceiling\":50,\"altitudeReference\":\"amsl\"}")
                        .text("field"))
                .isEqualTo("altitudeReference");

        TestHttpClient.Answer child = byParent.post("/api/v1/access-keys", "{\"label\":\"child\",\"ceiling\":50}");
        assertThat(child.json().path("area").path("radius").asDouble()).isEqualTo(500);
        assertThat(child.json().path("floor").asDouble()).isEqualTo(10);
        assertThat(child.json().path("ceiling").asDouble()).isEqualTo(50);
    }

    @Test
    void doNothingBeyondLookingWhereTheirAreaDoesNotCount() {
        KeyScope scope =
                KeyScope.ALL.boundedBy(new FlightBounds(null, new AltitudeBand(null, 60.0, Altitude.Reference.HOME)));
        TestHttpClient http = new TestHttpClient(
                house, house.key(OrganisationId.HOME, new KeyRights(Role.ADMINISTRATOR, scope, null)));

        assertThat(http.get("/api/v1/users").text("detail"))
                .isEqualTo("This access key has an area or heights, and what has none is closed to it.");
        assertThat(http.post("/api/v1/virtual-drones", "{}").text("detail"))
                .isEqualTo("This access key has an area or heights, and a virtual drone flies without it.");
        assertThat(http.get("/api/v1/virtual-drones").status()).isEqualTo(200);
        assertThat(http.get("/metrics").status()).isEqualTo(200);
    }

    @Test
    void areRenewedWithTheSameRights() {
        TestHttpClient user = tenant.http(Role.OPERATOR);
        TestHttpClient.Answer made =
                user.post("/api/v1/access-keys", "{\"label\":\"script\",\"operations\":[\"view\"]}");
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, made.text("key"))) {
            stream.await(message -> message.path("type").asString().equals("drones"));

            TestHttpClient.Answer renewed = user.post("/api/v1/access-keys/" + made.text("id") + "/renew", "");

            assertThat(stream.awaitClose()).startsWith("This session has ended");
            assertThat(renewed.text("id")).isEqualTo(made.text("id"));
            assertThat(new TestHttpClient(house, made.text("key"))
                            .get("/api/v1/drones")
                            .status())
                    .isEqualTo(401);
            TestHttpClient byNew = new TestHttpClient(house, renewed.text("key"));
            assertThat(byNew.get("/api/v1/drones").status()).isEqualTo(200);
            assertThat(byNew.post("/api/v1/missions", "{}").status()).isEqualTo(403);
        }
    }

    @Test
    void sayWhenTheyWereLastUsed() {
        TestHttpClient user = tenant.http(Role.OPERATOR);
        TestHttpClient.Answer made = user.post("/api/v1/access-keys", "{\"label\":\"script\"}");
        assertThat(made.json().path("lastUsedAt").isNull()).isTrue();

        TestHttpClient script = new TestHttpClient(house, made.text("key"));
        script.get("/api/v1/drones");

        assertThat(script.get("/api/v1/access-keys")
                        .json()
                        .path("accessKeys")
                        .get(0)
                        .path("lastUsedAt")
                        .asString())
                .startsWith("20");
    }

    @Test
    void areAskedForInWordsThatAreChecked() {
        TestHttpClient user = tenant.http(Role.OPERATOR);

        assertThat(user.post("/api/v1/access-keys", "{\"label\":\"x\",\"operations\":[\"fly\"]}")
                        .text("allowed"))
                .isEqualTo("a list of view, plan, command and administer");
        assertThat(user.post("/api/v1/access-keys", "{\"label\":\"x\",\"drones\":[]}")
                        .text("field"))
                .isEqualTo("drones");
        assertThat(user.post("/api/v1/access-keys", "{\"label\":\"x\",\"drones\":[null]}")
                        .text("field"))
                .startsWith("drones");
        assertThat(user.post("/api/v1/access-keys", "{\"label\":\"x\",\"area\":{\"type\":\"Point\",\"radius\":5}}")
                        .text("field"))
                .isEqualTo("area.coordinates");
        assertThat(user.post("/api/v1/access-keys", "{\"label\":\"x\",\"floor\":50,\"ceiling\":40}")
                        .text("field"))
                .isEqualTo("ceiling");
        assertThat(user.post("/api/v1/access-keys", "{\"label\":\"x\",\"days\":0}")
                        .text("field"))
                .isEqualTo("days");
        assertThat(user.post("/api/v1/access-keys", "{\"label\":\"x\",\"days\":1.5}")
                        .text("detail"))
                .isEqualTo("\"days\" must be a whole number.");
    }

    private void armed(FlightPhase phase, double meters) {
        mine.says(new DroneEvent.ModeReported("GUIDED", true));
        mine.says(new DroneEvent.PositionReported(new Position(new Geodetic(47.3977, 8.5456), 488 + meters, meters)));
        mine.says(new DroneEvent.PhaseReported(phase));
        ConditionWait.until(
                "it is heard",
                () -> house.cloud().drone(new DroneId(mine.id())).filter(state -> state.phase() == phase));
    }

    private static String circle(int radius) {
        return "\"area\":{\"type\":\"Point\",\"coordinates\":[8.5456,47.3977],\"radius\":" + radius + "}";
    }

    private static String goTo(double latitude, int meters) {
        return "{\"type\":\"goTo\",\"latitude\":" + latitude + ",\"longitude\":8.5456,\"altitude\":" + meters + "}";
    }

    private static KeyRights operatorOf(ScriptedVehicle vehicle) {
        KeyScope scope = new KeyScope(Set.of(new DroneId(vehicle.id())), EnumSet.allOf(Permission.class));
        return new KeyRights(Role.OPERATOR, scope, null);
    }

    private static KeyRights operator(Permission permission) {
        return new KeyRights(Role.OPERATOR, new KeyScope(null, Set.of(permission)), null);
    }

    private static String refusal(TestHttpClient http, String members) {
        TestHttpClient.Answer answer = http.post("/api/v1/access-keys", "{\"label\":\"child\"," + members + "}");
        assertThat(answer.status()).isEqualTo(403);
        return answer.text("detail");
    }

    private static TestHttpClient.Answer remove(TestHttpClient http, String id) {
        return http.send("/api/v1/access-keys/" + id, HttpRequest.Builder::DELETE);
    }
}
