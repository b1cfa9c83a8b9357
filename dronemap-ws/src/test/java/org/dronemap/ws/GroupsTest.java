package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.util.List;
import org.dronemap.core.access.Role;
import org.dronemap.ws.testserver.OrganisationMember;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Groups of users and fleets of drones, and what those see who come and go. */
class GroupsTest {
    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestServer house = tenant.server();
    private ScriptedVehicle one;
    private ScriptedVehicle two;
    private OrganisationMember root;
    private OrganisationMember ann;

    @BeforeEach
    void open() {
        one = tenant.vehicle();
        two = tenant.vehicle();
        root = tenant.member("root", Role.ADMINISTRATOR);
        ann = tenant.member("ann", Role.OPERATOR);
    }

    @Test
    void reachThroughGroupsAndFleetsAsTheyAreNow() {
        String crew = root.http()
                .post("/api/v1/groups", "{\"name\":\"Crew\",\"members\":[\"" + ann.name() + "\"]}")
                .text("id");
        String fleet = root.http()
                .post("/api/v1/fleets", "{\"name\":\"Trucks\",\"drones\":[\"" + one.id() + "\"]}")
                .text("id");
        bind("groups/" + crew, true);
        grant("\"group\":\"" + crew + "\",\"fleet\":\"" + fleet + "\"");
        assertThat(drones(ann)).containsExactly(one.id());
        put("/api/v1/fleets/" + fleet, "{\"name\":\"Trucks\",\"drones\":[\"" + two.id() + "\"]}");
        assertThat(drones(ann)).containsExactly(two.id());
    }

    @Test
    void showNobodyMoreWhoLeavesAGroupThatSeesOnlyWhatWasGranted() {
        String crew = groupOfAnn();
        put("/api/v1/groups/" + crew, "{\"name\":\"Crew\",\"members\":[]}");
        assertThat(drones(ann)).isEmpty();

        bind("users/" + ann.name(), false);
        assertThat(drones(ann)).containsExactlyInAnyOrder(one.id(), two.id());
    }

    @Test
    void showNobodyMoreWhoseGroupIsRemoved() {
        assertThat(root.http()
                        .send("/api/v1/groups/" + groupOfAnn(), HttpRequest.Builder::DELETE)
                        .status())
                .isEqualTo(204);
        assertThat(drones(ann)).isEmpty();
        assertThat(root.http().get("/api/v1/users").raw().body()).contains("\"onlyGranted\":true");
    }

    /** Sees only what was granted, which is one drone. */
    private String groupOfAnn() {
        String crew = root.http()
                .post("/api/v1/groups", "{\"name\":\"Crew\",\"members\":[\"" + ann.name() + "\"]}")
                .text("id");
        bind("groups/" + crew, true);
        grant("\"group\":\"" + crew + "\",\"drones\":[\"" + one.id() + "\"]");
        assertThat(drones(ann)).containsExactly(one.id());
        return crew;
    }

    private void grant(String whoAndWhat) {
        TestHttpClient.Answer made =
                root.http().post("/api/v1/grants", "{" + whoAndWhat + ",\"operations\":[\"plan\"]}");
        assertThat(made.status()).as(made.raw().body()).isEqualTo(201);
    }

    private void bind(String whom, boolean only) {
        put("/api/v1/" + whom + "/only-granted", "{\"onlyGranted\":" + only + "}");
    }

    private static List<String> drones(OrganisationMember by) {
        return by.http().get("/api/v1/drones").json().path("drones").findValuesAsString("id");
    }

    private void put(String path, String body) {
        TestHttpClient.Answer put = root.http()
                .send(
                        path,
                        request -> request.header("Content-Type", "application/json")
                                .PUT(HttpRequest.BodyPublishers.ofString(body)));
        assertThat(put.status()).as(put.raw().body()).isBetween(200, 204);
    }
}
