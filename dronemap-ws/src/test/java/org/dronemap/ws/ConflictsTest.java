package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.time.Instant;
import java.util.Locale;
import java.util.Optional;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.ws.testserver.ConditionWait;
import org.dronemap.ws.testserver.ImmediateCopter;
import org.dronemap.ws.testserver.OrganisationMember;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;

/** Refusals by 409: each operation that lists it answers so where things as they are forbid it. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class ConflictsTest {
    private static final String API = "/api/v1/";
    private static final String PLACE = "\"latitude\":47.3985,\"longitude\":8.5456";
    private static final String WAYPOINTS = "\"seconds\":0.1,\"waypoints\":[{" + PLACE + ",\"altitude\":30}]}";
    private static final String RALLY = "{\"points\":[{" + PLACE + ",\"altitude\":30}]}";
    private static final String FENCE =
            "{\"zones\":[{\"type\":\"circle\",\"inside\":true,\"radius\":500,\"center\":{" + PLACE + "}}]}";
    private static final String MISSION =
            "{\"name\":\"Roofs\",\"items\":[{\"type\":\"waypoint\",\"altitude\":20," + PLACE + "}]}";

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private OrganisationMember administrator;
    private TestHttpClient http;

    @BeforeAll
    void open() {
        administrator = tenant.member("root", Role.ADMINISTRATOR);
        http = administrator.http();
    }

    private static TestHttpClient.Answer send(TestHttpClient who, String method, String path, String body) {
        return who.send(
                API + path,
                request -> request.header("Content-Type", "application/json")
                        .method(method, HttpRequest.BodyPublishers.ofString(body)));
    }

    /** {@code operation}: its method and its address below the version. */
    private void conflicts(String operation, String body) {
        conflicts(http, operation, body);
    }

    private static void conflicts(TestHttpClient who, String operation, String body) {
        String[] words = operation.split(" ");
        TestHttpClient.Answer answer = send(who, words[0], words[1], body);
        assertThat(answer.status()).as(operation + ": " + answer.raw().body()).isEqualTo(409);
    }

    private String made(String path, String body) {
        TestHttpClient.Answer made = http.post(API + path, body);
        assertThat(made.text("id")).as(path + ": " + made.raw().body()).isNotEmpty();
        return made.text("id");
    }

    @Test
    void aRecordingThatIsPlayedIsNotCommanded() {
        String id = ScriptedVehicle.played(
                tenant.server().cloud(), 18_000 + tenant.server().number());
        tenant.server().grants().lend(new DroneId(id), tenant.organisation());
        String drone = "drones/" + id;

        conflicts("POST " + drone + "/control/request", "{}");
        conflicts("POST " + drone + "/control/take-over", "{\"reason\":\"smoke\"}");
        conflicts("PUT " + drone + "/fence", FENCE);
        conflicts("POST " + drone + "/fence/refresh", "");
        conflicts("PUT " + drone + "/rally-points", RALLY);
        conflicts("POST " + drone + "/rally-points/refresh", "");
        conflicts("POST " + drone + "/logs/refresh", "");
        conflicts("POST " + drone + "/parameters/refresh", "");
        conflicts("PUT " + drone + "/parameters/RTL_ALT", "{\"value\":2000}");
        conflicts("PUT " + drone + "/link-security", "{\"policy\":\"off\"}");
        conflicts("PUT warehouse/" + id, "{}");
    }

    private ImmediateCopter copter(String name) {
        return tenant.copter(name, new Geodetic(47.3977, 8.5456))
                .wellHeard(tenant.server().cloud());
    }

    private void await(String path, String state) {
        ConditionWait.until(
                path + " is " + state,
                () -> Optional.of(http.get(API + path).text("state")).filter(state::equals));
    }

    @Test
    void aMissionRunThatIsOverIsNotChanged() {
        ImmediateCopter copter = copter("Falcon");
        String plan = made("plans", "{\"drones\":[\"" + copter.id() + "\"]," + WAYPOINTS);
        await("plans/" + plan, "finished");
        String run = "runs/" + made("runs", "{\"plan\":\"" + plan + "\"}");
        assertThat(http.post(API + run + "/stop", "").status()).isEqualTo(200);
        copter.isOnGround();
        await(run, "over");

        conflicts("POST " + run + "/waypoints", "{}");
        conflicts("PATCH " + run + "/waypoints/1", "{}");
        conflicts("DELETE " + run + "/waypoints/1", "");
        conflicts("POST " + run + "/barriers", "{}");
        conflicts("POST " + run + "/drones", "{}");
        conflicts("POST " + run + "/drones/" + copter.id() + "/resume", "");
        conflicts("POST " + run + "/drones/" + copter.id() + "/give-up", "");
        conflicts("POST " + run + "/answers/1", "{}");
        conflicts("POST " + run + "/pause", "");
        conflicts("POST " + run + "/continue", "");
        conflicts("POST " + run + "/stop", "");
    }

    @Test
    void aFollowThatIsOverHearsNoPositions() {
        ImmediateCopter copter = copter("Heron");
        assertThat(send(http, "PUT", "warehouse/" + copter.id(), "{}").status()).isEqualTo(200);
        String follow = "follows/" + made("follows", "{\"drone\":\"" + copter.id() + "\"," + PLACE + "}");
        assertThat(http.post(API + follow + "/cancel", "").status()).isEqualTo(200);

        conflicts(
                "POST " + follow + "/positions",
                "{\"sent\":\"" + Instant.now() + "\",\"positions\":[{\"id\":1,\"at\":\"" + Instant.now()
                        + "\",\"accuracy\":1," + PLACE + "}]}");
    }

    @Test
    void aVirtualDroneDoesNotGoOnBeforeItBegan() {
        conflicts("POST virtual-drones/" + made("virtual-drones", MISSION) + "/resume", "");
    }

    @Test
    void nobodyTakesTheOwnRightsAway() {
        String me = administrator.name();
        String group = made("groups", "{\"name\":\"Pilots\",\"members\":[\"" + me + "\"]}");

        conflicts("PUT groups/" + group + "/only-granted", "{\"onlyGranted\":true}");
        conflicts("POST users/" + me + "/password", "");
    }

    @Test
    void anOrganisationIsNotCalledLikeAnother() {
        TestHttpClient server =
                new TestHttpClient(tenant.server(), tenant.server().key(Role.ADMINISTRATOR));
        String name = tenant.unique("Hill Survey");
        assertThat(server.post(API + "organisations", "{\"name\":\"" + name + "\"}")
                        .status())
                .isEqualTo(201);

        conflicts(
                server,
                "PATCH organisations/" + tenant.organisation().value(),
                "{\"name\":\"" + name.toUpperCase(Locale.ROOT) + "\"}");
    }

    @Test
    void aTourIsNotOrderedForADroneWithoutAHome() {
        conflicts("POST tours", "{\"drone\":\"" + tenant.vehicle().id() + "\"," + WAYPOINTS);
    }

    @Test
    void aFlightThatWasNotRecordedHasNoFileOfFrames() {
        ScriptedVehicle vehicle = tenant.vehicle();
        vehicle.says(new DroneEvent.ModeReported("GUIDED", true));
        vehicle.says(new DroneEvent.ModeReported("GUIDED", false));
        String flight = ConditionWait.until(
                "the flight is known",
                () -> Optional.of(http.get(API + "flights?drone=" + vehicle.id())
                                .json()
                                .path("flights")
                                .path(0)
                                .path("id")
                                .asString(""))
                        .filter(id -> !id.isEmpty()));

        conflicts("GET flights/" + flight + "/telemetry/file?form=tlog", "");
    }
}
