package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.VehicleLog;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.ws.testserver.ConditionWait;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Commands are answered with 202 while they are under way, and with 200 and their outcome to those who wait for it. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class UnderWayTest {
    private static final String PLACE = "\"latitude\":47.3977,\"longitude\":8.5456";
    private static final String FENCE =
            "{\"zones\":[{\"type\":\"circle\",\"inside\":true,\"radius\":500,\"center\":{" + PLACE + "}}]}";
    private static final String ZONE =
            "{\"type\":\"Feature\",\"geometry\":{\"type\":\"Point\",\"coordinates\":[10,60]},\"properties\":"
                    + "{\"name\":\"Lake\",\"kind\":\"exclusion\",\"radius\":50,\"drone\":\"%s\"}}";

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private TestHttpClient http;
    private ScriptedVehicle quick;

    /** An operation below the version, of the drone that is ID, with a body. */
    private record Asked(String method, String path, String body) {
        TestHttpClient.Answer of(TestHttpClient who, ScriptedVehicle vehicle, String query) {
            return who.send(
                    "/api/v1/" + path.replace("ID", vehicle.id()) + query,
                    request -> request.header("Content-Type", "application/json")
                            .method(method, HttpRequest.BodyPublishers.ofString(body.replace("ID", vehicle.id()))));
        }
    }

    @BeforeAll
    void open() {
        http = tenant.http(Role.ADMINISTRATOR);
        quick = tenant.vehicle();
        quick.says(new DroneEvent.LogsRead(List.of(new VehicleLog(7, null, 10))));
        assertThat(http.post("/api/v1/zones", ZONE.formatted(quick.id())).status())
                .isEqualTo(201);
    }

    static Stream<Asked> waitedFor() {
        return Stream.of(
                new Asked("POST", "commands", "{\"drones\":[\"ID\"],\"command\":{\"type\":\"readHome\"}}"),
                new Asked("POST", "drones/ID/commands", "{\"type\":\"readHome\"}"),
                new Asked("POST", "drones/ID/parameters/refresh", ""),
                new Asked("PUT", "drones/ID/parameters/RTL_ALT", "{\"value\":2000}"));
    }

    static Stream<Asked> begun() {
        return Stream.of(
                new Asked("POST", "drones/ID/fence/refresh", ""),
                new Asked("PUT", "drones/ID/fence", FENCE),
                new Asked("PUT", "drones/ID/fence/zones", ""),
                new Asked("DELETE", "drones/ID/fence", ""),
                new Asked("POST", "drones/ID/rally-points/refresh", ""),
                new Asked("PUT", "drones/ID/rally-points", "{\"points\":[{" + PLACE + ",\"altitude\":30}]}"),
                new Asked("DELETE", "drones/ID/rally-points", ""),
                new Asked("POST", "drones/ID/logs/refresh", ""),
                new Asked("POST", "drones/ID/logs/7/download", ""));
    }

    @ParameterizedTest
    @MethodSource("waitedFor")
    void whoDoesNotWaitIsToldThatItIsUnderWay(Asked asked) {
        ScriptedVehicle slow = tenant.vehicle();
        slow.takesItsTime();

        assertThat(asked.of(http, slow, "").status()).isEqualTo(202);
    }

    @ParameterizedTest
    @MethodSource("waitedFor")
    void whoWaitsIsToldTheOutcome(Asked asked) {
        assertThat(asked.of(http, quick, "?wait=20").status()).isEqualTo(200);
    }

    /** However quick the vehicle is. */
    @ParameterizedTest
    @MethodSource("begun")
    void whereNobodyCanWaitItIsAlwaysUnderWay(Asked asked) {
        int status = ConditionWait.until(
                "the one before has ended",
                () -> Optional.of(asked.of(http, quick, "").status()).filter(one -> one != 409));

        assertThat(status).isEqualTo(202);
    }
}
