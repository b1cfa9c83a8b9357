package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import org.dronemap.core.access.Permission;
import org.dronemap.core.access.Role;
import org.dronemap.ws.testserver.ExposedOperations;
import org.dronemap.ws.testserver.OrganisationMember;
import org.dronemap.ws.testserver.ResourceScopeTable.Whose;
import org.dronemap.ws.testserver.RightsTable;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.TestHttpClient;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** Tries all that the running server exposes for each role and each grant, and compares with docs/security.md. */
class GrantedReachTest extends ReachTrial {
    /** Where the gate decides, and not the address. */
    private static final String COMMANDS = "POST /api/v1/drones/{id}/commands";
    /** What the gate says to those who may not. */
    private static final Pattern REFUSAL = Pattern.compile("You were not granted|Your role may|A planner may");
    /** Open to those who plan and to those who command. */
    private static final String RELEASE = "DELETE /api/v1/drones/{id}/control";

    /** Made once for all tests. */
    private final List<Granted> everyGrant = new ArrayList<>();

    /** Somebody who sees only what was granted: this with our drone, or null: nothing. */
    private record Granted(Role role, @Nullable Permission permission, OrganisationMember member) {
        boolean may(Role needed) {
            return permission != null
                    && role.includes(needed)
                    && (needed.permission() == Permission.VIEW || needed.permission() == permission);
        }

        @Override
        public String toString() {
            return role + " granted " + permission;
        }
    }

    @Test
    void opensADroneToWhatWasGrantedAsFarAsTheRoleGoes() {
        RightsTable table = RightsTable.below("REST");
        int cells = 0;
        for (Granted granted : everyGrant()) {
            for (String operation : faces.rest()) {
                boolean ofDrone =
                        whose.of(operation).filter(Whose.DRONE::equals).isPresent();
                if (!ofDrone || !operation.contains("{") || operation.equals(COMMANDS)) {
                    continue;
                }
                cells++;
                if (granted.permission() == null) {
                    alike(
                            granted.member(),
                            operation,
                            own.thing(kind(operation)).orElseThrow());
                } else {
                    judge(
                            operation + " for " + granted,
                            granted.may(table.least(operation))
                                    || (operation.equals(RELEASE) && granted.may(Role.OPERATOR)),
                            rest(granted.member(), operation, ownThing(operation)));
                }
            }
        }
        assertThat(wrong).isEmpty();
        assertThat(cells).isGreaterThan(500);
    }

    @Test
    void keepsWhatConcernsEverythingFromThoseWhoSeeOnlyWhatWasGranted() {
        for (Granted granted : everyGrant()) {
            for (String operation : faces.rest()) {
                Whose about = whose.of(operation).orElseThrow();
                // A recording is looked for first, and is out of reach.
                boolean all =
                        !kind(operation).equals("recordings") && (about == Whose.ORGANISATION || about == Whose.SERVER);
                if (all) {
                    TestHttpClient.Answer answer = rest(granted.member(), operation, ABSENT);
                    if (answer.status() != 403) {
                        wrong.add(operation + " for " + granted + ": " + answer.status());
                    }
                }
            }
        }
        assertThat(wrong).isEmpty();
    }

    @Test
    void letsCommandsThroughTheGateAsTheyWereGranted() {
        RightsTable table = RightsTable.below("Commands");
        for (Granted granted : everyGrant()) {
            for (String type : table.operations()) {
                TestHttpClient.Answer answer = granted.member()
                        .http()
                        .post(
                                "/api/v1/drones/" + own.drone().id() + "/commands",
                                faces.commands().least(type).toString());
                boolean refused = answer.status() == 403
                        || answer.status() == 404
                        || REFUSAL.matcher(answer.text("detail")).find();
                if (refused == granted.may(table.least(type))) {
                    wrong.add(type + " for " + granted + ": " + answer.raw().body());
                }
            }
        }
        assertThat(wrong).isEmpty();
    }

    @Test
    void opensADroneToWhatWasGrantedThroughSoap() {
        RightsTable table = RightsTable.below("REST");
        RightsTable commands = RightsTable.below("Commands");
        int cells = 0;
        for (Granted granted : everyGrant()) {
            for (String operation : faces.soap()) {
                String rest = faces.restOf(operation);
                boolean ofDrone = whose.of(rest).filter(Whose.DRONE::equals).isPresent();
                if (!ofDrone || faces.isList(operation)) {
                    continue;
                }
                cells++;
                if (rest.equals(COMMANDS)) {
                    Role least = commands.least(faces.commandOf(operation));
                    String answer = faces.command(
                                    granted.member().http(),
                                    operation,
                                    own.drone().id())
                            .raw()
                            .body();
                    boolean refused = ExposedOperations.wrong(answer).matches("forbidden|unknown")
                            || REFUSAL.matcher(answer).find();
                    if (refused == granted.may(least)) {
                        wrong.add(operation + " for " + granted + ": " + answer);
                    }
                } else if (granted.permission() == null) {
                    alikeInSoap(
                            granted.member(), operation, own.thing(kind(rest)).orElseThrow());
                } else {
                    judgeSoap(
                            operation + " for " + granted,
                            granted.may(table.least(rest)) || (rest.equals(RELEASE) && granted.may(Role.OPERATOR)),
                            soap(granted.member(), operation, ownThing(rest)));
                }
            }
        }
        assertThat(wrong).isEmpty();
        assertThat(cells).isGreaterThan(500);
    }

    /** One for each role and operation, each sees only what was granted; some were granted nothing. */
    private List<Granted> everyGrant() {
        if (everyGrant.isEmpty()) {
            everyGrant.addAll(madeGrants());
        }
        return everyGrant;
    }

    private List<Granted> madeGrants() {
        List<Granted> all = new ArrayList<>();
        TestHttpClient root = own.administrator().http();
        List<@Nullable Permission> permissions = new ArrayList<>(List.of(Permission.values()));
        permissions.add(null);
        for (Role role : List.of(Role.VIEWER, Role.PLANNER, Role.OPERATOR, Role.SUPERVISOR, Role.ADMINISTRATOR)) {
            for (Permission permission : permissions) {
                OrganisationMember member = own.member("granted-" + house.number(), role);
                assertThat(put(root, "/api/v1/users/" + member.name() + "/only-granted", "{\"onlyGranted\":true}")
                                .status())
                        .isEqualTo(204);
                if (permission != null) {
                    grant(root, member, own.drone(), permission.name().toLowerCase(Locale.ROOT));
                }
                // What may be done with another drone must not rub off.
                for (String operation : List.of("plan", "command", "administer")) {
                    grant(root, member, spare, operation);
                }
                all.add(new Granted(role, permission, member));
            }
        }
        return all;
    }

    private static void grant(TestHttpClient root, OrganisationMember to, ScriptedVehicle drone, String operation) {
        String body = "{\"user\":\"" + to.name() + "\",\"drones\":[\"" + drone.id() + "\"],\"operations\":[\""
                + operation + "\"]}";
        assertThat(root.post("/api/v1/grants", body).status()).isEqualTo(201);
    }
}
