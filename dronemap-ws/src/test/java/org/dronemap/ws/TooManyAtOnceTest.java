package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.ws.testserver.ConditionWait;
import org.dronemap.ws.testserver.ImmediateCopter;
import org.dronemap.ws.testserver.SoapClient;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Plans whose drones do not all have a way home below the ceiling are not started, by any face. */
class TooManyAtOnceTest {
    private static final double LATITUDE = 47.3977;
    private static final double LONGITUDE = 8.5456;
    /** Some 4 m: all of them come near each other. */
    private static final double PADS_DEGREES = 0.00005;

    private static final String SENTENCE =
            "[12] of 4 drones have a way home between \\d\\d m \\(the highest way\\) and the"
                    + " ceiling of %d m above the home of “.+”: layers are 6 m apart. Take off fewer at once, raise the ceiling, or"
                    + " keep their areas and pads 15 m apart.";

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final String key = tenant.key(Role.OPERATOR);
    private final TestHttpClient operator = new TestHttpClient(tenant.server(), key);
    private final List<ImmediateCopter> copters = new ArrayList<>();

    @BeforeEach
    void open() {
        for (int i = 0; i < 4; i++) {
            copters.add(tenant.copter(tenant.unique("Copter"), new Geodetic(LATITUDE, LONGITUDE + i * PADS_DEGREES))
                    .wellHeard(tenant.server().cloud()));
        }
    }

    private void ceiling(long meters) {
        String zone = "{\"type\":\"Feature\",\"geometry\":{\"type\":\"Point\",\"coordinates\":[" + LONGITUDE + ","
                + LATITUDE + "]},\"properties\":{\"name\":\"Field\",\"kind\":\"inclusion\",\"radius\":5000,\"ceiling\":"
                + meters + "}}";
        assertThat(tenant.http(Role.SUPERVISOR).post("/api/v1/zones", zone).status())
                .isEqualTo(201);
    }

    /** North of their pads, so that each has one. */
    private String planned() {
        List<String> waypoints = new ArrayList<>();
        List<String> ids = new ArrayList<>();
        for (int i = 0; i < copters.size(); i++) {
            ids.add("\"" + copters.get(i).id() + "\"");
            waypoints.add("{\"latitude\":" + (LATITUDE + 0.0008) + ",\"longitude\":" + (LONGITUDE + i * 0.0004)
                    + ",\"altitude\":20}");
        }
        String id = operator.post(
                        "/api/v1/plans",
                        "{\"drones\":[" + String.join(",", ids) + "],\"seconds\":0.5,\"waypoints\":["
                                + String.join(",", waypoints) + "]}")
                .text("id");
        ConditionWait.until(
                "the plan is finished",
                () -> Optional.of(operator.get("/api/v1/plans/" + id))
                        .filter(plan -> plan.text("state").equals("finished")));
        return id;
    }

    private void requireNothingWasSent() {
        for (ImmediateCopter copter : copters) {
            assertThat(copter.performed()).isEmpty();
            assertThat(tenant.server()
                            .cloud()
                            .controls()
                            .control(new DroneId(copter.id()))
                            .tenure())
                    .isNull();
        }
        assertThat(operator.get("/api/v1/runs").json().path("runs").size()).isZero();
    }

    private static void requireRefused(TestHttpClient.Answer answer, long ceiling) {
        assertThat(answer.status()).as(answer.raw().body()).isEqualTo(409);
        assertThat(answer.text("code")).isEqualTo("ways-home-do-not-fit");
        assertThat(answer.text("detail")).matches(String.format(SENTENCE, ceiling));
        assertThat(answer.json().at("/parameters/drones").asInt()).isEqualTo(4);
        assertThat(answer.text("detail"))
                .startsWith(answer.json().at("/parameters/most").asInt() + " of 4 drones");
    }

    @Test
    void aRunIsRefusedWithTheNumberAndNothingIsSent() {
        // The layers above 20 m are at 26, 32 and 38 m; two have room at most, and fewer where the plan leads higher.
        ceiling(37);
        String plan = planned();
        requireRefused(operator.post("/api/v1/runs", "{\"plan\":\"" + plan + "\"}"), 37);
        SoapClient soap = SoapClient.withKey(tenant.server(), key);
        assertThatThrownBy(() -> soap.call("startRun", "plan", plan))
                .hasMessageContaining(" of 4 drones have a way home between");
        requireNothingWasSent();
    }

    @Test
    void aPlanIsNotStartedEither() {
        ceiling(37);
        String plan = planned();
        requireRefused(operator.post("/api/v1/plans/" + plan + "/accept", "{\"start\":true}"), 37);
        requireNothingWasSent();
        // Its missions alone go on board: nobody flies by that.
        assertThat(operator.post("/api/v1/plans/" + plan + "/accept?wait=20", "{}")
                        .status())
                .isEqualTo(200);
    }

    @Test
    void whereEachHasAWayHomeItBegins() {
        ceiling(60);
        assertThat(operator.post("/api/v1/runs", "{\"plan\":\"" + planned() + "\"}")
                        .status())
                .isEqualTo(201);
    }

    @Test
    void withoutACeilingItBegins() {
        assertThat(operator.post("/api/v1/runs", "{\"plan\":\"" + planned() + "\"}")
                        .status())
                .isEqualTo(201);
    }
}
