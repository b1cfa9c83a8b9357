package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.dronemap.core.access.Permission;
import org.dronemap.core.access.Role;
import org.dronemap.ws.testserver.OrganisationMember;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.ResourceScopeTable.Whose;
import org.dronemap.ws.testserver.RightsTable;
import org.dronemap.ws.testserver.RightsTable.Caller;
import org.dronemap.ws.testserver.TestHttpClient;
import org.junit.jupiter.api.Test;

/**
 * Tries each role on virtual drones: one's own, a colleague's, another organisation's and none; and each grant of virtual
 * drones on those and on real ones; and compares with docs/security.md.
 */
class VirtualReachTest extends ReachTrial {
    private static final String VIRTUAL = "/api/v1/virtual-drones";
    private static final RightsTable TABLE = RightsTable.below("REST");
    private static final Set<String> OPEN_TO_SUPERVISORS =
            Set.of("GET " + VIRTUAL + "/{id}", "POST " + VIRTUAL + "/{id}/stop");

    @Test
    void opensOnesOwnAsTheRoleMay() {
        int cells = 0;
        for (Role role : Role.values()) {
            OrganisationMember member = own.member("virtually-" + house.number(), Role.ADMINISTRATOR);
            Map<String, String> things = oneForEach(member);
            demote(member, role);
            for (String operation : ofOneVirtual()) {
                boolean promised = TABLE.promises(operation, Caller.valueOf(role.name()));
                judge(operation + " for " + role, promised, rest(member, operation, things.get(operation)));
                cells++;
            }
        }
        assertThat(wrong).isEmpty();
        assertThat(cells).isGreaterThan(30);
    }

    @Test
    void letsSupervisorsSeeAndStopWhatIsAColleaguesAndHidesItFromOthers() {
        for (Role role : Role.values()) {
            for (String operation : ofOneVirtual()) {
                String thing = own.thing("virtual-drones").orElseThrow();
                if (!role.includes(Role.SUPERVISOR)) {
                    alike(ours.get(role), operation, thing);
                } else {
                    boolean promised = OPEN_TO_SUPERVISORS.contains(operation);
                    judge(operation + " for " + role, promised, rest(ours.get(role), operation, thing));
                }
            }
        }
        assertThat(wrong).isEmpty();
    }

    @Test
    void answersThoseOfAnotherOrganisationAsAbsentOnes() {
        String thing = foreign.thing("virtual-drones").orElseThrow();
        for (Role role : Role.values()) {
            ofOneVirtual().forEach(operation -> alike(ours.get(role), operation, thing));
        }
        assertThat(wrong).isEmpty();
    }

    @Test
    void answersThoseOfOthersAsAbsentOnesThroughSoap() {
        String colleagues = own.thing("virtual-drones").orElseThrow();
        String foreigns = foreign.thing("virtual-drones").orElseThrow();
        int cells = 0;
        for (Role role : Role.values()) {
            for (String operation : faces.soap()) {
                if (!faces.elementOf(operation).equals("virtualDroneId")) {
                    continue;
                }
                alikeInSoap(ours.get(role), operation, foreigns);
                if (!role.includes(Role.SUPERVISOR)) {
                    alikeInSoap(ours.get(role), operation, colleagues);
                }
                cells++;
            }
            String list = soap(ours.get(role), "listVirtualDrones", ABSENT);
            if (list.contains(foreigns) || (!role.includes(Role.SUPERVISOR) && list.contains(colleagues))) {
                wrong.add("listVirtualDrones for " + role + ": " + list);
            }
        }
        assertThat(wrong).isEmpty();
        assertThat(cells).isGreaterThan(20);
    }

    @Test
    void opensThemToWhatWasGrantedWithVirtualDronesAndRealOnesNot() {
        int cells = 0;
        for (Role role : List.of(Role.VIEWER, Role.PLANNER, Role.OPERATOR, Role.SUPERVISOR, Role.ADMINISTRATOR)) {
            for (Permission permission : Permission.values()) {
                OrganisationMember member = own.member("virtually-" + house.number(), Role.ADMINISTRATOR);
                Map<String, String> things = oneForEach(member);
                demote(member, role);
                grantVirtual(member, permission);
                for (String operation : ofOneVirtual()) {
                    Role needed = TABLE.least(operation);
                    boolean promised = role.includes(needed)
                            && (needed.permission() == Permission.VIEW || needed.permission() == permission);
                    judge(
                            operation + " for " + role + " granted " + permission,
                            promised,
                            rest(member, operation, things.get(operation)));
                    cells++;
                }
                cells += realOnesAreAbsent(member);
            }
        }
        assertThat(wrong).isEmpty();
        assertThat(cells).isGreaterThan(1_000);
    }

    private int realOnesAreAbsent(OrganisationMember member) {
        int cells = 0;
        for (String operation : faces.rest()) {
            boolean ofDrone = whose.of(operation).filter(Whose.DRONE::equals).isPresent();
            if (ofDrone && operation.contains("{")) {
                alike(member, operation, own.thing(kind(operation)).orElseThrow());
                cells++;
            }
        }
        for (String operation : faces.soap()) {
            String rest = faces.restOf(operation);
            boolean ofDrone = whose.of(rest).filter(Whose.DRONE::equals).isPresent();
            if (ofDrone && !faces.isList(operation)) {
                alikeInSoap(member, operation, own.thing(kind(rest)).orElseThrow());
                cells++;
            }
        }
        silent("GET /api/v1/drones for " + member.name(), member.http().get("/api/v1/drones"));
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, member.key())) {
            stream.await(message -> message.path("type").asString().equals("drones"));
            assertThat(stream.heard().toString())
                    .doesNotContain("\"" + own.drone().id() + "\"");
        }
        return cells + 2;
    }

    private void silent(String cell, TestHttpClient.Answer answer) {
        if (answer.raw().body().contains("\"" + own.drone().id() + "\"")) {
            wrong.add(cell + ": " + answer.raw().body());
        }
    }

    private Set<String> ofOneVirtual() {
        return faces.rest().stream()
                .filter(operation -> operation.contains(" " + VIRTUAL + "/{id}"))
                .collect(Collectors.toSet());
    }

    /** Some operations end what they are about. */
    private Map<String, String> oneForEach(OrganisationMember member) {
        Map<String, String> things = new LinkedHashMap<>();
        for (String operation : ofOneVirtual()) {
            String id = member.http().post(VIRTUAL, "{\"name\":\"A survey\"}").text("id");
            assertThat(id).as("a virtual drone of " + member.name()).isNotEmpty();
            things.put(operation, id);
        }
        return things;
    }

    /** Whoever may make none may still have some from better days. */
    private void demote(OrganisationMember member, Role role) {
        String body = "{\"role\":\"" + role.name().toLowerCase(Locale.ROOT) + "\"}";
        TestHttpClient.Answer answer = own.administrator()
                .http()
                .send(
                        "/api/v1/users/" + member.name(),
                        request -> request.header("Content-Type", "application/json")
                                .method("PATCH", HttpRequest.BodyPublishers.ofString(body)));
        assertThat(answer.status()).as(answer.raw().body()).isBetween(200, 204);
    }

    private void grantVirtual(OrganisationMember member, Permission permission) {
        TestHttpClient root = own.administrator().http();
        assertThat(put(root, "/api/v1/users/" + member.name() + "/only-granted", "{\"onlyGranted\":true}")
                        .status())
                .isEqualTo(204);
        String body = "{\"user\":\"" + member.name() + "\",\"virtual\":true,\"operations\":[\""
                + permission.name().toLowerCase(Locale.ROOT) + "\"]}";
        assertThat(root.post("/api/v1/grants", body).status()).isEqualTo(201);
    }
}
