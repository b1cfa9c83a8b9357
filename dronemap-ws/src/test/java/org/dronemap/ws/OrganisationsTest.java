package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.http.HttpRequest;
import java.time.Clock;
import java.util.List;
import java.util.Map;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.ws.environment.EnvironmentVariables;
import org.dronemap.ws.organisation.GrantChanges;
import org.dronemap.ws.organisation.OrganisationService;
import org.dronemap.ws.testserver.OrganisationMember;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.SharedServer;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.zone.ZoneService;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;

/** What those who run the server do with its organisations. */
class OrganisationsTest {
    private final TestServer house = SharedServer.get();
    private final ScriptedVehicle one = vehicle();
    private final ScriptedVehicle two = vehicle();
    private final OrganisationMember root =
            house.member(OrganisationId.HOME, "root-" + house.number(), Role.ADMINISTRATOR);
    private final OrganisationMember ann = house.member(OrganisationId.HOME, "ann-" + house.number(), Role.OPERATOR);

    private ScriptedVehicle vehicle() {
        return ScriptedVehicle.connect(house.cloud(), 20_000 + house.number());
    }

    @Test
    void areNoMoreThanTheServerIsSetTo() {
        root.http().post("/api/v1/organisations", "{\"name\":\"One " + house.number() + "\"}");
        OrganisationService full = new OrganisationService(
                house.bean(GrantChanges.class),
                house.bean(AccessStore.class),
                house.cloud(),
                house.bean(ZoneService.class),
                Clock.systemUTC(),
                new EnvironmentVariables(Map.of("DRONEMAP_ORGANISATIONS", "1")));

        assertThatThrownBy(() -> full.add(
                        new Principal("root", Role.ADMINISTRATOR), new OrganisationService.NameRequest("One more")))
                .hasMessage("There are 1 organisations already.");
    }

    @Test
    void letAnOrganisationBeginByAnInvitation() {
        List<String> before = drones(root);
        assertThat(before).contains(one.id());
        String rescue = root.http()
                .post("/api/v1/organisations", "{\"name\":\"Mountain rescue " + house.number() + "\"}")
                .text("id");
        String code = root.http()
                .post(
                        "/api/v1/invitations",
                        "{\"label\":\"Bea\",\"role\":\"administrator\",\"organisation\":\"" + rescue + "\"}")
                .text("code");
        String bea = "bea-" + house.number();
        new TestHttpClient(house, "")
                .post(
                        "/api/v1/registrations",
                        "{\"name\":\"" + bea + "\",\"password\":\"a-long-password\",\"invitation\":\"" + code + "\"}");
        assertThat(put("/api/v1/organisations/" + rescue + "/drones/" + one.id(), ""))
                .isEqualTo(200);

        List<String> left = before.stream().filter(id -> !id.equals(one.id())).toList();
        assertThat(drones(root)).contains(two.id()).containsExactlyInAnyOrderElementsOf(left);
        JsonNode organisation = root.http()
                .get("/api/v1/organisations")
                .json()
                .path("organisations")
                .valueStream()
                .filter(each -> each.path("id").asString().equals(rescue))
                .findFirst()
                .orElseThrow();
        assertThat(organisation.path("users").asInt()).isEqualTo(1);
        assertThat(organisation.path("drones").asInt()).isEqualTo(1);
        assertThat(root.http().get("/api/v1/users").json().toString()).doesNotContain(bea);
        assertThat(delete("/api/v1/organisations/" + rescue)).isEqualTo(409);
    }

    @Test
    void letNobodyInviteIntoAnotherOrganisationWhoDoesNotRunTheServer() {
        String rescue = root.http()
                .post("/api/v1/organisations", "{\"name\":\"Mountain rescue " + house.number() + "\"}")
                .text("id");
        OrganisationMember bea = house.member(new OrganisationId(rescue), "bea-" + house.number(), Role.ADMINISTRATOR);

        for (String organisation : List.of(OrganisationId.HOME.value(), "nosuchorganisation")) {
            String body = "{\"label\":\"Eve\",\"role\":\"administrator\",\"organisation\":\"" + organisation + "\"}";
            assertThat(bea.http().post("/api/v1/invitations", body).status()).isEqualTo(403);
        }
        String own = "{\"label\":\"Cleo\",\"role\":\"viewer\"}";
        assertThat(bea.http().post("/api/v1/invitations", own).status()).isEqualTo(201);
    }

    @Test
    void bindOtherOrganisationsByZonesOfTheServerAndNotByThoseOfEachOther() {
        String rescue = root.http()
                .post("/api/v1/organisations", "{\"name\":\"Mountain rescue " + house.number() + "\"}")
                .text("id");
        OrganisationMember bea = house.member(new OrganisationId(rescue), "bea-" + house.number(), Role.SUPERVISOR);
        put("/api/v1/organisations/" + rescue + "/drones/" + two.id(), "");
        String theirs = zone(bea, "theirs");
        assertThat(mayGo(ann, one)).isTrue();
        assertThat(mayGo(bea, two)).isFalse();
        bea.http().send("/api/v1/zones/" + theirs, HttpRequest.Builder::DELETE);
        assertThat(mayGo(bea, two)).isTrue();
        String everybodys = zone(root, "airport");
        try {
            assertThat(mayGo(ann, one)).isFalse();
            assertThat(mayGo(bea, two)).isFalse();
            assertThat(bea.http().get("/api/v1/zones/" + everybodys).status()).isEqualTo(200);
            assertThat(bea.http()
                            .send("/api/v1/zones/" + everybodys, HttpRequest.Builder::DELETE)
                            .status())
                    .isEqualTo(403);
        } finally {
            assertThat(delete("/api/v1/zones/" + everybodys)).isEqualTo(204);
        }
    }

    private static String zone(OrganisationMember by, String name) {
        return by.http()
                .post(
                        "/api/v1/zones",
                        "{\"type\":\"Feature\",\"geometry\":{\"type\":\"Point\",\"coordinates\":[8.55,47.41]},"
                                + "\"properties\":{\"name\":\"" + name + "\",\"kind\":\"exclusion\",\"radius\":300}}")
                .text("id");
    }

    /** Whether no zone speaks against it; the drone is disarmed, so it goes nowhere. */
    private boolean mayGo(OrganisationMember by, ScriptedVehicle drone) {
        String detail = by.http()
                .post(
                        "/api/v1/drones/" + drone.id() + "/commands",
                        "{\"type\":\"uploadMission\",\"items\":[{\"type\":\"waypoint\",\"latitude\":47.41,"
                                + "\"longitude\":8.55,\"altitude\":20}]}")
                .text("detail");
        return !detail.contains("zone");
    }

    private static List<String> drones(OrganisationMember by) {
        return by.http().get("/api/v1/drones").json().path("drones").findValuesAsString("id");
    }

    private int put(String path, String body) {
        return root.http()
                .send(
                        path,
                        request -> request.header("Content-Type", "application/json")
                                .PUT(HttpRequest.BodyPublishers.ofString(body)))
                .status();
    }

    private int delete(String path) {
        return root.http().send(path, HttpRequest.Builder::DELETE).status();
    }
}
