package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.http.HttpRequest;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronemap.core.access.KeyRights;
import org.dronemap.core.access.KeyScope;
import org.dronemap.core.access.Permission;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.ws.testserver.ConditionWait;
import org.dronemap.ws.testserver.ImmediateCopter;
import org.dronemap.ws.testserver.SoapClient;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;

class VirtualDronesTest {
    private static final String PATH = "/api/v1/virtual-drones";
    private static final String MISSION = "\"items\":[{\"type\":\"waypoint\",\"latitude\":47.398,\"longitude\":8.5456,"
            + "\"altitude\":20},{\"type\":\"waypoint\",\"latitude\":47.399,\"longitude\":8.5456,\"altitude\":20}]";

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestServer house = tenant.server();
    private TestHttpClient operator;
    private TestHttpClient supervisor;

    @BeforeEach
    void open() {
        operator = tenant.http(Role.OPERATOR);
        supervisor = tenant.http(Role.SUPERVISOR);
    }

    private ImmediateCopter falcon() {
        return tenant.copter("Falcon", new Geodetic(47.3977, 8.5456));
    }

    private void offer(ImmediateCopter copter) {
        assertThat(put(supervisor, "/api/v1/warehouse/" + copter.id(), "{}").status())
                .isEqualTo(200);
    }

    @Test
    void planWithoutADroneWaitInTheOrderOfAskingAndAreServedOneAfterTheOther() {
        String first = make(operator, "First");
        String second = make(operator, "Second");
        assertThat(start(operator, first)
                        .json()
                        .path("run")
                        .path("queue")
                        .path("position")
                        .asInt())
                .isEqualTo(1);
        JsonNode waiting = start(operator, second).json().path("run");
        assertThat(waiting.path("state").asString()).isEqualTo("queued");
        assertThat(waiting.path("queue").toString()).isEqualTo("{\"position\":2,\"length\":2}");

        ImmediateCopter falcon = falcon();
        offer(falcon);
        JsonNode flying = await(operator, first, "flying");
        assertThat(flying.path("run").path("drone").path("name").asString()).isEqualTo("Falcon");
        assertThat(flying.path("run").path("why").asString()).startsWith("“Falcon” was chosen: no other drone");
        assertThat(falcon.performed())
                .extracting(command -> command.getClass().getSimpleName())
                .containsExactly("UploadMission", "SetCloudLossAction", "Arm", "StartMission");
        assertThat(run(operator, second).path("queue").path("position").asInt()).isEqualTo(1);

        falcon.reaches(0);
        falcon.reaches(1);
        ConditionWait.until("a waypoint is flown", () -> flown(first) == 1 ? Optional.of(true) : Optional.empty());
        falcon.reaches(2);
        await(operator, first, "returning");
        falcon.isOnGround();
        await(operator, first, "done");
        await(operator, second, "flying");
    }

    @Test
    void areToldBeforeADroneThatWouldFlyForThemIsPutIntoTheWarehouse() {
        ImmediateCopter falcon = falcon();
        String before = "/api/v1/warehouse/" + falcon.id() + "/prospects";
        assertThat(supervisor.get(before).json().path("waiting").isEmpty()).isTrue();
        start(operator, make(operator, "Roofs"));

        JsonNode told = supervisor.get(before).json();
        assertThat(told.path("inWarehouse").asBoolean()).isFalse();
        assertThat(told.path("waiting").size()).isEqualTo(1);
        JsonNode first = told.path("waiting").path(0);
        assertThat(first.path("name").asString()).isEqualTo("Roofs");
        assertThat(first.path("flies").asBoolean()).isTrue();
        assertThat(first.path("why").isNull()).isTrue();
        assertThat(first.path("code").isNull()).isTrue();
        falcon.hasLeft(15);
        ConditionWait.until(
                "its battery is known to be low",
                () -> Optional.of(supervisor.get(before).json().path("waiting").path(0))
                        .filter(one -> one.path("code").asString().equals("battery-too-low")));
        assertThat(falcon.performed()).as("asking changes nothing").isEmpty();
        assertThat(supervisor.get("/api/v1/warehouse").json().path("drones").toString())
                .doesNotContain(falcon.id());
    }

    @Test
    void tellByACodeWhyADroneOfTheWarehouseCannotServe() {
        ImmediateCopter falcon = falcon();
        falcon.hasLeft(15);
        offer(falcon);
        String id = make(operator, "Roofs");
        start(operator, id);

        JsonNode unfit = ConditionWait.until(
                "why it cannot serve is told",
                () -> Optional.of(run(operator, id).path("unfit").path(0)).filter(one -> one.has("code")));
        assertThat(unfit.path("drone").path("id").asString()).isEqualTo(falcon.id());
        assertThat(unfit.path("code").asString()).isEqualTo("battery-too-low");
        assertThat(unfit.path("why").asString()).startsWith("Its battery has 15 %");
    }

    @Test
    void handTheRestOfAMissionToAnotherDrone() {
        ImmediateCopter falcon = falcon();
        offer(falcon);
        String id = make(operator, "Survey");
        start(operator, id);
        await(operator, id, "flying");
        falcon.reaches(0);
        falcon.reaches(1);
        ConditionWait.until("a waypoint is flown", () -> flown(id) == 1 ? Optional.of(true) : Optional.empty());
        falcon.isOnGround();
        await(operator, id, "queued");
        assertThat(run(operator, id).path("unfit").toString()).doesNotContain("null");

        ImmediateCopter heron = tenant.copter("Heron", new Geodetic(47.3990, 8.5470));
        offer(heron);
        await(operator, id, "flying");
        Command first = heron.performed().get(0);
        assertThat(first)
                .isInstanceOfSatisfying(
                        Command.UploadMission.class,
                        upload -> assertThat(upload.mission().items()).hasSize(3));
    }

    @Test
    void waitForTheirUserWhenASupervisorCallsTheDroneBack() {
        ImmediateCopter falcon = falcon();
        offer(falcon);
        String id = make(operator, "Survey");
        start(operator, id);
        await(operator, id, "flying");

        assertThat(operator.post("/api/v1/drones/" + falcon.id() + "/commands", "{\"type\":\"land\"}")
                        .text("detail"))
                .startsWith("The virtual drone “Survey” of ");
        supervisor.post("/api/v1/drones/" + falcon.id() + "/commands?wait=10", "{\"type\":\"returnToLaunch\"}");
        JsonNode suspended = await(operator, id, "suspended");
        assertThat(suspended.path("actions").path("resume").path("allowed").asBoolean())
                .isTrue();
        assertThat(suspended.path("run").path("detail").asString()).contains("return to launch");
        falcon.isOnGround();
        assertThat(operator.post(PATH + "/" + id + "/resume", "{}").status()).isEqualTo(202);
        await(operator, id, "flying");
    }

    @Test
    void stopOnTheirUsersWordAndBringTheDroneHome() {
        ImmediateCopter falcon = falcon();
        offer(falcon);
        String id = make(operator, "Survey");
        start(operator, id);
        await(operator, id, "flying");

        assertThat(delete(operator, PATH + "/" + id).status()).isEqualTo(409);
        assertThat(operator.post(PATH + "/" + id + "/stop", "{}").status()).isEqualTo(202);
        ConditionWait.until(
                "it is called home",
                () -> falcon.performed().stream()
                        .filter(Command.ReturnToLaunch.class::isInstance)
                        .findFirst());
        falcon.isOnGround();
        await(operator, id, "stopped");
        assertThat(delete(operator, PATH + "/" + id).status()).isEqualTo(204);
        assertThat(operator.get(PATH + "/" + id).status()).isEqualTo(404);
    }

    @Test
    void belongToWhoMadeThem() {
        TestHttpClient other = tenant.http(Role.OPERATOR);
        String id = make(operator, "Mine");

        assertThat(other.get(PATH + "/" + id).status()).isEqualTo(404);
        assertThat(start(other, id).status()).isEqualTo(404);
        assertThat(other.get(PATH).json().path("virtualDrones").size()).isZero();
        assertThat(supervisor.get(PATH + "/" + id).status()).isEqualTo(200);
        assertThat(start(supervisor, id).status()).isEqualTo(403);
        TestHttpClient narrow = new TestHttpClient(
                house,
                tenant.key(new KeyRights(
                        Role.OPERATOR,
                        new KeyScope(Set.of(new DroneId("drone-1")), EnumSet.allOf(Permission.class)),
                        null)));
        assertThat(narrow.post(PATH, "{\"name\":\"A\"}").status()).isEqualTo(403);
    }

    @Test
    void sayWhatIsWrongWithThem() {
        assertThat(operator.post(PATH, "{\"name\":\" \"}").text("field")).isEqualTo("name");
        assertThat(operator.post(PATH, "{\"name\":\"A\",\"needs\":{\"kind\":\"bird\"}}")
                        .text("field"))
                .isEqualTo("needs.kind");
        assertThat(operator.post(PATH, "{\"name\":\"A\",\"needs\":{\"capabilities\":[\"swim\"]}}")
                        .text("field"))
                .isEqualTo("needs.capabilities[0]");
        assertThat(operator.post(PATH, "{\"name\":\"A\",\"needs\":{\"enduranceMinutes\":0}}")
                        .text("allowed"))
                .isEqualTo("1 to 1440 minutes");
        assertThat(operator.post(PATH, "{\"name\":\"A\",\"needs\":{\"area\":{\"latitude\":47,\"longitude\":8}}}")
                        .text("field"))
                .isEqualTo("needs.area.radius");
        assertThat(operator.post(
                                PATH,
                                "{\"name\":\"A\",\"items\":[{\"type\":\"land\"},{\"type\":\"waypoint\","
                                        + "\"latitude\":47,\"longitude\":8,\"altitude\":20}]}")
                        .text("detail"))
                .startsWith("Item 1: a take-off comes first");
        String empty = operator.post(PATH, "{\"name\":\"A\"}").text("id");
        TestHttpClient.Answer unplanned = start(operator, empty);
        assertThat(unplanned.text("detail")).isEqualTo("Plan its mission first.");
        assertThat(unplanned.text("code")).isEqualTo("virtual-drone-without-mission");
        assertThat(unplanned.json().path("parameters").path("id").asString()).isEqualTo(empty);
        assertThat(operator.post(PATH + "/" + empty + "/start", "{\"onCloudLoss\":\"panic\"}")
                        .text("allowed"))
                .isEqualTo("continue or rtl");
    }

    @Test
    void flyTheSameWayThroughSoap() {
        ImmediateCopter falcon = falcon();
        offer(falcon);
        SoapClient soap = SoapClient.withKey(house, tenant.key(Role.OPERATOR));
        List<Map<String, Object>> way = List.of(waypoint(47.398), waypoint(47.399));
        assertThatThrownBy(() ->
                        soap.call("addVirtualDrone", "name", "Survey", "needs", Map.of("kind", "bird"), "items", way))
                .hasMessageContaining("needs.kind");
        SoapClient.Answer made =
                soap.call("addVirtualDrone", "name", "Survey", "needs", Map.of("kind", "multicopter"), "items", way);
        String id = made.text("id");
        assertThat(made.text("run.state")).isEmpty();
        assertThat(made.texts("items.item")).hasSizeGreaterThanOrEqualTo(2);
        assertThat(soap.call("listVirtualDrones").texts("virtualDrones.item.name"))
                .containsExactly("Survey");
        assertThatThrownBy(() -> soap.call("startVirtualDrone", "virtualDroneId", id, "onCloudLoss", "fly"))
                .hasMessageContaining("onCloudLoss");

        soap.call("startVirtualDrone", "virtualDroneId", id, "onCloudLoss", "rtl");
        ConditionWait.until(
                "it flies",
                () -> Optional.of(through(soap, id))
                        .filter(now -> now.text("run.state").equals("flying")));
        assertThat(through(soap, id).text("run.drone.id")).isEqualTo(falcon.id());
        assertThatThrownBy(() -> soap.call("removeVirtualDrone", "virtualDroneId", id))
                .hasMessageContaining("stop it first");
        assertThatThrownBy(() -> soap.call("resumeVirtualDrone", "virtualDroneId", id))
                .hasMessageContaining("It does not wait");
        soap.call("stopVirtualDrone", "virtualDroneId", id);
        falcon.isOnGround();
        ConditionWait.until(
                "it is stopped",
                () -> Optional.of(through(soap, id))
                        .filter(now -> now.text("run.state").equals("stopped")));
        soap.call("removeVirtualDrone", "virtualDroneId", id);
        assertThatThrownBy(() -> through(soap, id)).hasMessageContaining("There is no virtual drone");
    }

    private static SoapClient.Answer through(SoapClient soap, String id) {
        return soap.call("getVirtualDrone", "virtualDroneId", id);
    }

    private static Map<String, Object> waypoint(double latitude) {
        return Map.of("waypoint", Map.of("latitude", latitude, "longitude", 8.5456, "altitude", 20.0));
    }

    @Test
    void keepThoseOutWhoSeeOnlyWhatWasGrantedUntilVirtualDronesAre() {
        TestHttpClient holder = tenant.http(Role.OPERATOR);
        String name = holder.get("/api/v1/session").text("name");
        TestHttpClient administrator = tenant.http(Role.ADMINISTRATOR);
        String only = "/api/v1/users/" + name + "/only-granted";
        assertThat(put(administrator, only, "{\"onlyGranted\":true}").status()).isEqualTo(204);
        assertThat(holder.post(PATH, "{\"name\":\"A\"}").status()).isEqualTo(403);

        String grant = "{\"user\":\"" + name + "\",\"virtual\":true,\"operations\":[\"plan\",\"command\"]}";
        assertThat(administrator.post("/api/v1/grants", grant).status()).isEqualTo(201);
        start(holder, make(holder, "Survey"));
        offer(falcon());
        String id =
                holder.get(PATH).json().path("virtualDrones").path(0).path("id").asString();
        assertThat(await(holder, id, "flying").path("run").path("why").asString())
                .startsWith("A drone was chosen: no other one could serve.");
    }

    private String make(TestHttpClient who, String name) {
        TestHttpClient.Answer made = who.post(PATH, "{\"name\":\"" + name + "\"," + MISSION + "}");
        assertThat(made.status()).as(made.raw().body()).isEqualTo(201);
        return made.text("id");
    }

    private static TestHttpClient.Answer start(TestHttpClient who, String id) {
        return who.post(PATH + "/" + id + "/start", "{}");
    }

    private static JsonNode run(TestHttpClient who, String id) {
        return who.get(PATH + "/" + id).json().path("run");
    }

    private int flown(String id) {
        return flownBy(operator, id);
    }

    private static int flownBy(TestHttpClient who, String id) {
        return run(who, id).path("flown").asInt();
    }

    private static JsonNode await(TestHttpClient who, String id, String state) {
        return ConditionWait.until(
                "it is " + state,
                () -> Optional.of(who.get(PATH + "/" + id).json())
                        .filter(drone ->
                                drone.path("run").path("state").asString("").equals(state)));
    }

    private static TestHttpClient.Answer put(TestHttpClient who, String path, String body) {
        return who.send(
                path,
                request -> request.header("Content-Type", "application/json")
                        .PUT(HttpRequest.BodyPublishers.ofString(body)));
    }

    private static TestHttpClient.Answer delete(TestHttpClient who, String path) {
        return who.send(path, HttpRequest.Builder::DELETE);
    }
}
