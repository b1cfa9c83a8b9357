package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;

class BroadcastTest {
    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestServer house = tenant.server();
    private final String id = tenant.unique("one-for-all");
    private ScriptedVehicle willing;
    private ScriptedVehicle unwilling;
    private ScriptedVehicle silent;
    private TestHttpClient operator;

    @BeforeEach
    void open() {
        willing = tenant.vehicle();
        unwilling = tenant.vehicle();
        unwilling.ends(command ->
                new Outcome.Refused("vehicle", "PreArm: compass 7 not healthy", OutcomeCode.VEHICLE_REFUSED));
        silent = tenant.vehicle();
        silent.ends(command -> new Outcome.TimedOut("No answer from the vehicle within 8 s (9 tries)."));
        operator = tenant.http(Role.OPERATOR);
    }

    private TestHttpClient.Answer arm(String drones) {
        return operator.post(
                "/api/v1/commands?wait=30",
                "{\"id\":\"" + id + "\",\"drones\":" + drones + ",\"command\":{\"type\":\"arm\"}}");
    }

    private static List<String> results(TestHttpClient.Answer answer) {
        List<String> results = new ArrayList<>();
        for (JsonNode result : answer.json().path("results")) {
            results.add(result.path("drone").asString("") + " "
                    + result.path("command").path("outcome").path("result").asString("none"));
        }
        return results;
    }

    @Test
    void eachDroneHasAnOutcomeOfItsOwn() {
        TestHttpClient.Answer answer = arm("\"all\"");

        assertThat(answer.status()).isEqualTo(200);
        assertThat(results(answer))
                .containsExactlyInAnyOrder(
                        willing.id() + " succeeded", unwilling.id() + " refused", silent.id() + " timedOut");
        assertThat(List.of(willing, unwilling, silent))
                .allSatisfy(vehicle -> assertThat(vehicle.performed())
                        .filteredOn(Command.Arm.class::isInstance)
                        .hasSize(1));
    }

    @Test
    void anIdIsOfWhatWasSaidWithIt() {
        arm("[\"" + willing.id() + "\"]");
        TestHttpClient.Answer other = operator.post(
                "/api/v1/commands?wait=30",
                "{\"id\":\"" + id + "\",\"drones\":\"all\",\"command\":{\"type\":\"disarm\"}}");

        assertThat(other.status()).isEqualTo(409);
        assertThat(other.text("detail")).contains("belongs to another command");
        assertThat(unwilling.performed()).isEmpty();
    }

    @Test
    void onlyThoseAskedForAreAskedInThatOrder() {
        TestHttpClient.Answer answer = arm("[\"" + unwilling.id() + "\",\"" + willing.id() + "\"]");

        assertThat(results(answer)).containsExactly(unwilling.id() + " refused", willing.id() + " succeeded");
        assertThat(silent.performed()).isEmpty();
    }

    @Test
    void anUnknownDroneKeepsNoOtherFromItsCommand() {
        TestHttpClient.Answer answer = arm("[\"nobody\",\"" + willing.id() + "\"]");

        assertThat(results(answer)).containsExactly("nobody none", willing.id() + " succeeded");
        assertThat(answer.json().path("results").get(0).path("problem").asString(""))
                .isEqualTo("There is no drone nobody.");
        assertThat(answer.json().path("results").get(0).path("code").asString(""))
                .isEqualTo("drone-unknown");
        assertThat(answer.json()
                        .path("results")
                        .get(0)
                        .path("parameters")
                        .path("drone")
                        .asString(""))
                .isEqualTo("nobody");
    }

    @Test
    void theSameIdActsOnceOnEachDrone() {
        arm("\"all\"");
        arm("\"all\"");

        assertThat(willing.performed())
                .filteredOn(Command.Arm.class::isInstance)
                .hasSize(1);
        assertThat(unwilling.performed())
                .filteredOn(Command.Arm.class::isInstance)
                .hasSize(1);
    }
}
