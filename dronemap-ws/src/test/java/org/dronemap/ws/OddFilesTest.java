package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.net.http.HttpRequest;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.core.parameter.ParameterType;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;

/**
 * All operations that take a file of another program, as the description lists them: one odd piece among good ones
 * neither throws the others away nor vanishes.
 */
class OddFilesTest {
    private static final String ZONES = "POST /api/v1/zones/import";
    private static final String PARAMETERS = "POST /api/v1/drones/{id}/parameters/file";
    /** Its frames are played as they are; what is none is counted by the player. */
    private static final String RECORDINGS = "POST /api/v1/replays";

    private static final String RING = "[[9.1,46.2],[9.2,46.2],[9.2,46.3],[9.1,46.2]]";
    private static final String KML_AREA = "<Placemark><Polygon><outerBoundaryIs><LinearRing><coordinates>"
            + "9.1,46.2 9.2,46.2 9.2,46.3 9.1,46.2</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark>";

    /** By operation and kind of content: good, odd, good. */
    private static final Map<String, Map<String, String>> FILES = Map.of(
            ZONES,
            Map.of(
                    "application/geo+json",
                    "{\"type\":\"FeatureCollection\",\"features\":[" + feature("Polygon", "[" + RING + "]") + ","
                            + feature("LineString", RING) + "," + feature("Polygon", "[" + RING + "]") + "]}",
                    "application/vnd.google-earth.kml+xml",
                    "<kml>" + KML_AREA + "<Placemark><Point><coordinates>9,46</coordinates></Point></Placemark>"
                            + KML_AREA + "</kml>"),
            PARAMETERS,
            Map.of("text/plain", "RTL_ALT,1500\nRTL_ALT_FINAL 0,5\nLAND_SPEED,50\n"));

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestHttpClient supervisor = tenant.http(Role.SUPERVISOR);

    private static String feature(String type, String coordinates) {
        return "{\"type\":\"Feature\",\"properties\":null,\"geometry\":{\"type\":\"" + type + "\",\"coordinates\":"
                + coordinates + "}}";
    }

    @Test
    void eachOperationThatTakesAFileIsTried() {
        JsonNode paths = supervisor.get("/api/openapi.json").json().path("paths");
        TreeSet<String> takes = new TreeSet<>();
        for (String path : paths.propertyNames()) {
            JsonNode content = paths.path(path).path("post").path("requestBody").path("content");
            if (!content.isMissingNode() && !content.has("application/json")) {
                takes.add("POST " + path);
            }
        }

        assertThat(takes).containsExactlyInAnyOrder(ZONES, PARAMETERS, RECORDINGS);
    }

    @Test
    void moreZonesThanThereIsRoomForAreRefusedWithTheWayOut() {
        List<String> many = Collections.nCopies(501, feature("Polygon", "[" + RING + "]"));
        String file = "{\"type\":\"FeatureCollection\",\"features\":[" + String.join(",", many) + "]}";

        TestHttpClient.Answer answer = supervisor.send(
                ZONES.substring("POST ".length()),
                request -> request.header("Content-Type", "application/geo+json")
                        .POST(HttpRequest.BodyPublishers.ofString(file)));

        assertThat(answer.status()).isEqualTo(409);
        assertThat(answer.json().path("detail").asString())
                .contains("500 zones at most", "None was added", "import the part of the file");
    }

    @Test
    void anOddPieceIsNamedAndTheOthersAreTaken() {
        ScriptedVehicle vehicle = tenant.vehicle();
        vehicle.says(new DroneEvent.ParametersRead(List.of(
                new Parameter("RTL_ALT", ParameterType.INT16, 1500),
                new Parameter("LAND_SPEED", ParameterType.INT16, 50))));
        await().until(() -> supervisor
                        .get("/api/v1/drones/" + vehicle.id() + "/parameters")
                        .json()
                        .path("total")
                        .asInt()
                == 2);

        FILES.forEach((operation, contents) -> contents.forEach((type, file) -> {
            String path = operation.substring("POST ".length()).replace("{id}", vehicle.id());
            TestHttpClient.Answer answer = supervisor.send(
                    path,
                    request -> request.header("Content-Type", type).POST(HttpRequest.BodyPublishers.ofString(file)));

            assertThat(answer.status())
                    .as("%s %s", operation, answer.raw().body())
                    .isBetween(200, 202);
            assertThat(answer.json().path("leftOut").size()).as(type).isEqualTo(1);
            assertThat(answer.json().path("leftOut").path(0).path("code").asString())
                    .as(type)
                    .isIn(Stream.of(ValueProblem.values())
                            .map(ValueProblem::word)
                            .toList());
            assertThat(answer.json().path("leftOut").path(0).path("why").asString())
                    .as(type)
                    .endsWith(".");
            int taken = answer.json().path("features").size()
                    + answer.json().path("same").asInt(0);
            assertThat(taken).as(type).isEqualTo(2);
        }));
    }
}
