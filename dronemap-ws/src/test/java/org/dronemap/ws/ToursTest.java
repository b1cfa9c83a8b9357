package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.access.Role;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.ws.testserver.ImmediateCopter;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;

/** The waypoints of one drone, put into a good order for who edits its mission. */
class ToursTest {
    private static final String PATH = "/api/v1/tours";
    private static final double LATITUDE = 47.3977;
    private static final double LONGITUDE = 8.5456;

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestServer house = tenant.server();
    private TestHttpClient planner;
    private ImmediateCopter falcon;

    @BeforeEach
    void open() {
        planner = tenant.http(Role.PLANNER);
        falcon = tenant.copter("Falcon", new Geodetic(LATITUDE, LONGITUDE));
    }

    /** So many times 100 m or so to the north of it. */
    private static String north(double steps) {
        return "{\"latitude\":" + (LATITUDE + steps * 0.001) + ",\"longitude\":" + LONGITUDE + ",\"altitude\":30}";
    }

    private TestHttpClient.Answer ask(String members) {
        return planner.post(PATH, "{\"drone\":\"" + falcon.id() + "\",\"seconds\":0.1," + members + "}");
    }

    private static List<Integer> order(TestHttpClient.Answer answer) {
        assertThat(answer.status()).as(answer.raw().body()).isEqualTo(200);
        List<Integer> order = new ArrayList<>();
        answer.json().path("order").forEach(number -> order.add(number.asInt()));
        return order;
    }

    @Test
    void keepTheLastWaypointWhereTheDroneStaysThere() {
        TestHttpClient.Answer answer = ask("\"ending\":\"hold\",\"waypoints\":[" + north(3) + "," + north(1) + ","
                + north(2) + "," + north(4) + "]");

        assertThat(order(answer)).containsExactly(1, 2, 0, 3);
        JsonNode tour = answer.json();
        assertThat(tour.path("after").path("distance").asDouble()).isBetween(440.0, 450.0);
        assertThat(tour.path("before").path("distance").asDouble()).isGreaterThan(600);
        assertThat(tour.path("before").path("seconds").asDouble())
                .isGreaterThan(tour.path("after").path("seconds").asDouble());
        assertThat(tour.path("gap").asDouble()).isZero();
        assertThat(falcon.performed()).isEmpty();
    }

    @Test
    void leadHomeWhereTheDroneReturns() {
        // A square: across it and back, or around it.
        String around = "{\"latitude\":" + LATITUDE + ",\"longitude\":" + (LONGITUDE + 0.003) + ",\"altitude\":30}";
        String far =
                "{\"latitude\":" + (LATITUDE + 0.002) + ",\"longitude\":" + (LONGITUDE + 0.003) + ",\"altitude\":30}";

        assertThat(order(ask("\"waypoints\":[" + far + "," + north(2) + "," + around + "]")))
                .isIn(List.of(1, 0, 2), List.of(2, 0, 1));
    }

    @Test
    void putWhatCannotBeVisitedLastAndSayWhy() {
        String zone = "{\"type\":\"Feature\",\"geometry\":{\"type\":\"Point\",\"coordinates\":[" + LONGITUDE + ","
                + (LATITUDE + 0.001) + "]},\"properties\":{\"name\":\"Crane\",\"kind\":\"exclusion\",\"radius\":40}}";
        assertThat(tenant.http(Role.SUPERVISOR).post("/api/v1/zones", zone).status())
                .isEqualTo(201);

        TestHttpClient.Answer answer = ask("\"waypoints\":[" + north(1) + "," + north(3) + "," + north(2) + "]");
        assertThat(order(answer)).last().isEqualTo(0);
        JsonNode left = answer.json().path("unserved").path(0);
        assertThat(left.path("why").asString("")).contains("the no-fly zone “Crane”");
        assertThat(left.path("place").path("latitude").asDouble()).isEqualTo(LATITUDE + 0.001);
    }

    @Test
    void sayWhatIsWrongWithWhatWasAsked() {
        assertThat(planner.post(PATH, "{}").text("field")).isEqualTo("drone");
        assertThat(ask("\"waypoints\":[]").text("field")).isEqualTo("waypoints");
        assertThat(ask("\"ending\":\"dive\",\"waypoints\":[" + north(1) + "]").text("field"))
                .isEqualTo("ending");
        assertThat(ask("\"waypoints\":[{\"latitude\":95,\"longitude\":8,\"altitude\":20}]")
                        .text("field"))
                .isEqualTo("waypoints[0].latitude");
        assertThat(tenant.http(Role.VIEWER).post(PATH, "{}").status()).isEqualTo(403);
        assertThat(planner.post(PATH, "{\"drone\":\"nosuchdrone\",\"waypoints\":[" + north(1) + "]}")
                        .status())
                .isEqualTo(404);
    }
}
