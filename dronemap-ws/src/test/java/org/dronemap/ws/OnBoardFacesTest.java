package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.net.http.HttpRequest;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.ReadLogs;
import org.dronemap.core.command.SetFence;
import org.dronemap.core.command.SetRallyPoints;
import org.dronemap.core.command.VehicleLogSink;
import org.dronemap.core.drone.AreaMap;
import org.dronemap.core.drone.OnboardFence;
import org.dronemap.core.drone.OnboardRallyPoints;
import org.dronemap.core.drone.Picture;
import org.dronemap.core.drone.VehicleLog;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.core.parameter.ParameterType;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What a vehicle keeps on board, through REST: fence, rally points, logs and files of parameters. */
class OnBoardFacesTest {
    private static final String LOG = "0123456789".repeat(9);
    private static final String CORNER = "{\"latitude\":47.39,\"longitude\":8.54}";

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestHttpClient operator = tenant.http(Role.OPERATOR);
    private final ScriptedVehicle vehicle = tenant.vehicle();
    private final String path = "/api/v1/drones/" + vehicle.id();

    @BeforeEach
    void connect() {
        vehicle.ends(this::obey);
    }

    private Outcome obey(Command command) {
        if (command instanceof SetFence set) {
            vehicle.says(new DroneEvent.FenceRead(new OnboardFence(set.zones(), set.returnPoint(), List.of())));
        } else if (command instanceof SetRallyPoints set) {
            vehicle.says(new DroneEvent.RallyPointsRead(OnboardRallyPoints.of(set.points())));
        } else if (command instanceof ReadLogs) {
            vehicle.says(new DroneEvent.LogsRead(List.of(new VehicleLog(2, null, LOG.length()))));
        } else if (command instanceof Command.DownloadLog download) {
            VehicleLogSink sink = download.sink();
            assertThat(sink.put(0, LOG.getBytes(StandardCharsets.US_ASCII))).isTrue();
            assertThat(sink.complete(LOG.length())).isTrue();
        }
        return new Outcome.Succeeded();
    }

    private TestHttpClient.Answer put(String where, String body) {
        return operator.send(
                path + where,
                request -> request.header("Content-Type", "application/json")
                        .PUT(HttpRequest.BodyPublishers.ofString(body)));
    }

    private TestHttpClient.Answer delete(String where) {
        return operator.send(path + where, HttpRequest.Builder::DELETE);
    }

    private void succeeds(TestHttpClient.Answer given) {
        assertThat(given.status()).as(given.raw().body()).isBetween(200, 202);
        await().until(
                        () -> operator.get("/api/v1/commands/" + given.text("id"))
                                .json()
                                .path("outcome")
                                .path("result")
                                .asString(""),
                        "succeeded"::equals);
    }

    @Test
    void aFenceGoesRoundAndIsTakenAway() {
        String zones = "{\"zones\":[{\"type\":\"polygon\",\"inside\":true,\"corners\":[" + CORNER
                + ",{\"latitude\":47.41,\"longitude\":8.54},{\"latitude\":47.4,\"longitude\":8.56}]},"
                + "{\"type\":\"circle\",\"inside\":false,\"center\":" + CORNER
                + ",\"radius\":0.5}],\"returnPoint\":{\"latitude\":47.4,\"longitude\":8.545,\"altitude\":50.0,"
                + "\"altitudeReference\":\"amsl\"},\"leftOut\":[]}";
        assertThat(operator.get(path + "/fence").raw().body())
                .isEqualTo("{\"zones\":null,\"returnPoint\":null,\"leftOut\":null}");

        succeeds(put("/fence", zones));
        assertThat(operator.get(path + "/fence").raw().body()).isEqualTo(zones);

        TestHttpClient.Answer broken = put("/fence", "{\"zones\":[{\"type\":\"circle\",\"inside\":true}]}");
        assertThat(broken.status()).isEqualTo(422);
        assertThat(broken.text("field")).isEqualTo("zones[0].center.latitude");
        succeeds(delete("/fence"));
        succeeds(operator.post(path + "/fence/refresh", ""));
        assertThat(operator.get(path + "/fence").raw().body())
                .isEqualTo("{\"zones\":[],\"returnPoint\":null,\"leftOut\":[]}");
    }

    @Test
    void aMemberOfAnotherKindOfZoneIsRefused() {
        TestHttpClient.Answer polygon = put(
                "/fence",
                "{\"zones\":[{\"type\":\"polygon\",\"inside\":true,\"corners\":[" + CORNER + "],\"radius\":50}]}");
        TestHttpClient.Answer circle = put(
                "/fence",
                "{\"zones\":[{\"type\":\"circle\",\"inside\":true,\"corners\":[],\"center\":" + CORNER
                        + ",\"radius\":50}]}");

        assertThat(polygon.status()).isEqualTo(422);
        assertThat(polygon.text("detail"))
                .isEqualTo("There is no member \"zones[0].radius\" here; there are: type, inside, corners.");
        assertThat(circle.status()).isEqualTo(422);
        assertThat(circle.text("detail"))
                .isEqualTo("There is no member \"zones[0].corners\" here; there are: type, inside, center, radius.");
        assertThat(vehicle.performed()).isEmpty();
    }

    static Stream<Arguments> zonesOfNoKind() {
        return Stream.of(
                Arguments.of("{\"inside\":true}", "\"zones[0].type\" is missing; it must be polygon or circle."),
                Arguments.of(
                        "{\"type\":\"oval\",\"inside\":true}",
                        "\"zones[0].type\" must be polygon or circle, not \"oval\"."));
    }

    @ParameterizedTest
    @MethodSource("zonesOfNoKind")
    void aZoneOfNoKindIsRefused(String zone, String sentence) {
        TestHttpClient.Answer refused = put("/fence", "{\"zones\":[" + zone + "]}");

        assertThat(refused.status()).isEqualTo(422);
        assertThat(refused.text("detail")).isEqualTo(sentence);
    }

    @Test
    void rallyPointsGoRoundAndAreTakenAway() {
        String points = "{\"points\":[" + point("home", 25) + "," + point("amsl", 430) + "," + point("terrain", 60)
                + "],\"leftOut\":[]}";

        succeeds(put("/rally-points", points));
        assertThat(operator.get(path + "/rally-points").raw().body()).isEqualTo(points);

        succeeds(delete("/rally-points"));
        assertThat(operator.get(path + "/rally-points").raw().body()).isEqualTo("{\"points\":[],\"leftOut\":[]}");
    }

    private static String point(String reference, double altitude) {
        return "{\"latitude\":47.395,\"longitude\":8.545,\"altitude\":" + altitude + ",\"altitudeReference\":\""
                + reference + "\"}";
    }

    @Test
    void aRallyPointWithoutAReferenceIsAboveHome() {
        succeeds(put("/rally-points", "{\"points\":[{\"latitude\":47.395,\"longitude\":8.545,\"altitude\":-3}]}"));

        assertThat(operator.get(path + "/rally-points").raw().body())
                .isEqualTo("{\"points\":[" + point("home", -3) + "],\"leftOut\":[]}");
    }

    @Test
    void whatWasReadInPartIsNotWrittenBackForTheWhole() {
        String whole = "Item 3 (command 5005) is no part of a fence.";
        vehicle.says(new DroneEvent.FenceRead(new OnboardFence(List.of(), null, List.of(whole))));
        vehicle.says(new DroneEvent.RallyPointsRead(new OnboardRallyPoints(List.of(), List.of(whole))));

        for (String what : List.of("/fence", "/rally-points")) {
            await().until(() -> operator.get(path + what).json().path("leftOut").size() == 1);
            TestHttpClient.Answer refused =
                    put(what, operator.get(path + what).raw().body());

            assertThat(refused.status()).isEqualTo(422);
            assertThat(refused.text("field")).isEqualTo("leftOut");
            assertThat(refused.text("detail")).contains(whole);
        }
        assertThat(vehicle.performed()).isEmpty();
    }

    @Test
    void aLogIsListedFetchedSavedAndTakenAway() {
        assertThat(operator.get(path + "/logs").raw().body()).isEqualTo("{\"logs\":null}");
        succeeds(operator.post(path + "/logs/refresh", ""));
        assertThat(operator.get(path + "/logs")
                        .json()
                        .path("logs")
                        .path(0)
                        .path("sizeBytes")
                        .asLong())
                .isEqualTo(LOG.length());
        assertThat(operator.get(path + "/logs/2/file").status()).isEqualTo(409);

        succeeds(operator.post(path + "/logs/2/download", ""));
        await().until(() -> operator.get(path + "/logs/2/file").status() == 200);
        assertThat(operator.get(path + "/logs/2/file").raw().body()).isEqualTo(LOG);
        assertThat(operator.get(path + "/logs")
                        .json()
                        .path("logs")
                        .path(0)
                        .path("here")
                        .asBoolean())
                .isTrue();
        assertThat(operator.post(path + "/logs/2/download", "").status()).isEqualTo(409);

        assertThat(delete("/logs/second/file").status()).isEqualTo(422);
        assertThat(operator.get(path + "/logs/second/file").status()).isEqualTo(422);
        assertThat(delete("/logs/2/file").status()).isEqualTo(204);
        assertThat(operator.get(path + "/logs/2/file").status()).isEqualTo(409);
    }

    @ParameterizedTest
    @ValueSource(strings = {"list", "table"})
    void aFileOfParametersIsTheSameAsTheVehicle(String form) {
        vehicle.says(new DroneEvent.ParametersRead(List.of(
                new Parameter("RTL_ALT", ParameterType.INT16, 1500),
                new Parameter("RATE_P", ParameterType.REAL32, 0.1f))));
        await().until(() ->
                operator.get(path + "/parameters").json().path("total").asInt() == 2);

        TestHttpClient.Answer saved = operator.get(path + "/parameters/file?form=" + form);
        TestHttpClient.Answer compared = operator.send(
                path + "/parameters/file?dryRun=true",
                request -> request.header("Content-Type", "text/plain")
                        .POST(HttpRequest.BodyPublishers.ofString(saved.raw().body())));

        assertThat(saved.status()).isEqualTo(200);
        assertThat(compared.json().path("same").asInt()).isEqualTo(2);
        assertThat(compared.json().path("different").isEmpty()).isTrue();
        assertThat(compared.json().path("unknown").isEmpty()).isTrue();
        assertThat(compared.json().path("unfit").isEmpty()).isTrue();
        assertThat(compared.json().path("command").isNull()).isTrue();
        assertThat(vehicle.performed()).isEmpty();
    }

    @Test
    void parametersAreSavedInNoOtherForm() {
        vehicle.says(new DroneEvent.ParametersRead(List.of(new Parameter("RTL_ALT", ParameterType.INT16, 1500))));
        await().until(() ->
                operator.get(path + "/parameters").json().path("total").asInt() == 1);

        TestHttpClient.Answer saved = operator.get(path + "/parameters/file?form=poem");

        assertThat(saved.status()).isEqualTo(422);
        assertThat(saved.text("allowed")).isEqualTo("list or table");
    }

    @Test
    void itsPictureAndItsMapAreShownOnceThereAreAny() {
        byte[] png = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', 0};
        Picture picture = Picture.of(png).orElseThrow();
        assertThat(operator.get(path + "/sensed/picture").status()).isEqualTo(204);
        assertThat(operator.get(path + "/sensed/map").status()).isEqualTo(204);

        vehicle.says(new DroneEvent.PictureReported(picture));
        vehicle.says(new DroneEvent.MapReported(new AreaMap(picture, 0, 0, 10, 10)));

        for (String what : List.of("picture", "map")) {
            await().until(() -> operator.get(path + "/sensed/" + what).status(), status -> status == 200);
            assertThat(operator.get(path + "/sensed/" + what).raw().headers().firstValue("Content-Type"))
                    .hasValue("image/png");
        }
    }

    static Stream<Arguments> badCommandsForAll() {
        return Stream.of(
                Arguments.of("{\"command\":{\"type\":\"arm\"}}", "drones"),
                Arguments.of("{\"drones\":[],\"command\":{\"type\":\"arm\"}}", "drones"),
                Arguments.of("{\"drones\":\"all\"}", "command"),
                Arguments.of("{\"drones\":\"all\",\"command\":{\"type\":\"takeOff\"}}", "command.altitude"),
                Arguments.of("{\"drones\":\"all\",\"command\":{\"type\":\"fly\"}}", "command.type"),
                Arguments.of("{\"drones\":\"all\",\"command\":{\"type\":\"arm\"},\"id\":\"x\"}", "id"));
    }

    @ParameterizedTest
    @MethodSource("badCommandsForAll")
    void aBadCommandForAllIsSentToNobody(String body, String field) {
        TestHttpClient.Answer refused = operator.post("/api/v1/commands", body);

        assertThat(refused.status()).isEqualTo(422);
        assertThat(refused.text("field")).isEqualTo(field);
        assertThat(operator.get(path + "/commands").json().path("commands").isEmpty())
                .isTrue();
        assertThat(vehicle.performed()).isEmpty();
    }
}
