package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dronemap.core.access.Permission;
import org.dronemap.core.access.Role;
import org.dronemap.ws.house.Http;
import org.dronemap.ws.house.Member;
import org.dronemap.ws.house.RightsTable;
import org.dronemap.ws.house.WhoseTable.Whose;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** Tries all that the running server exposes for each role and each grant, and compares with docs/security.md. */
class GrantedReachTest extends ReachTrial {
    /** Where the gate decides, and not the address. */
    private static final String COMMANDS = "POST /api/v1/drones/{id}/commands";
    /** Open to those who plan and to those who command. */
    private static final String RELEASE = "DELETE /api/v1/drones/{id}/control";

    /** Somebody who sees only what was granted: this with our drone, or null: nothing. */
    private record Granted(Role role, @Nullable Permission permission, Member member) {
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
                if (about == Whose.ORGANISATION || about == Whose.SERVER) {
                    Http.Answer answer = rest(granted.member(), operation, ABSENT);
                    if (answer.status() != 403 && answer.status() != 404) {
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
                Http.Answer answer = granted.member()
                        .http()
                        .post("/api/v1/drones/" + own.drone().id() + "/commands", RightsTest.command(type));
                String why = answer.text("detail");
                boolean refused = answer.status() == 403
                        || answer.status() == 404
                        || why.startsWith("You were not granted")
                        || why.startsWith("Your role may")
                        || why.startsWith("A planner may");
                if (refused == granted.may(table.least(type))) {
                    wrong.add(type + " for " + granted + ": " + answer.raw().body());
                }
            }
        }
        assertThat(wrong).isEmpty();
    }

    @Test
    void opensADroneToWhatWasGrantedThroughSoap() {
        RightsTable table = RightsTable.below("SOAP");
        for (Granted granted : everyGrant()) {
            for (String operation : faces.soap()) {
                if (operation.equals("getDronesList")) {
                    continue;
                }
                String element = operation.equals("getCommand") ? "commandId" : "droneId";
                String kind = operation.equals("getCommand") ? "commands" : "drones";
                String answer = soap(
                        granted.member(), operation, element, own.thing(kind).orElseThrow());
                boolean open = !answer.contains("<code>forbidden</code>") && !answer.contains("<code>unknown</code>");
                // Who may command comes as far as the gate with what begins with planning.
                boolean toTheGate = table.least(operation) == Role.PLANNER && granted.may(Role.OPERATOR);
                if (open != (toTheGate || granted.may(table.least(operation)))) {
                    wrong.add(operation + " for " + granted + ": " + answer);
                }
            }
        }
        assertThat(wrong).isEmpty();
    }

    /** One for each role and operation, each sees only what was granted; some were granted nothing. */
    private List<Granted> everyGrant() {
        List<Granted> all = new ArrayList<>();
        Http root = own.administrator().http();
        List<@Nullable Permission> permissions = new ArrayList<>(List.of(Permission.values()));
        permissions.add(null);
        for (Role role : List.of(Role.VIEWER, Role.PLANNER, Role.OPERATOR, Role.SUPERVISOR, Role.ADMINISTRATOR)) {
            for (Permission permission : permissions) {
                Member member = own.member("granted-" + house.number(), role);
                assertThat(put(root, "/api/v1/users/" + member.name() + "/only-granted", "{\"onlyGranted\":true}")
                                .status())
                        .isEqualTo(204);
                if (permission != null) {
                    String body = "{\"user\":\"" + member.name() + "\",\"drones\":[\""
                            + own.drone().id() + "\"],\"operations\":[\""
                            + permission.name().toLowerCase(Locale.ROOT) + "\"]}";
                    assertThat(root.post("/api/v1/grants", body).status()).isEqualTo(201);
                }
                all.add(new Granted(role, permission, member));
            }
        }
        return all;
    }
}
