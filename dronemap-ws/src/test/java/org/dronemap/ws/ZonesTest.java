package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.net.http.HttpRequest;
import java.time.Duration;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronemap.core.access.KeyRights;
import org.dronemap.core.access.KeyScope;
import org.dronemap.core.access.Permission;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.SetFence;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Position;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.SoapClient;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;

class ZonesTest {
    private static final String ZONES = "/api/v1/zones";
    /** North of where the scripted vehicle is. */
    private static final String NORTH =
            "[[[8.544,47.400],[8.547,47.400],[8.547,47.402],[8.544,47.402],[8.544,47.400]]]";
    /** Around it. */
    private static final String HERE = "[[[8.544,47.397],[8.547,47.397],[8.547,47.399],[8.544,47.399],[8.544,47.397]]]";

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestServer house = tenant.server();
    private ScriptedVehicle vehicle;
    private TestHttpClient supervisor;
    private TestHttpClient operator;

    @BeforeEach
    void open() {
        vehicle = tenant.vehicle();
        supervisor = tenant.http(Role.SUPERVISOR);
        operator = tenant.http(Role.OPERATOR);
    }

    @Test
    void keepsAZoneAndGivesItBack() {
        TestHttpClient.Answer added = supervisor.post(
                ZONES,
                feature(
                        NORTH,
                        "\"name\":\"School\",\"floor\":0,\"ceiling\":80.5,\"until\":\"2099-01-01T00:00:00+01:00\""));

        assertThat(added.status()).isEqualTo(201);
        assertThat(added.raw().headers().firstValue("Location")).contains(ZONES + "/" + added.text("id"));
        assertThat(added.json().path("properties").path("until").asString()).isEqualTo("2098-12-31T23:00:00Z");
        assertThat(added.json().path("properties").path("kind").asString()).isEqualTo("exclusion");
        assertThat(added.json().path("properties").path("onBreach").asString()).isEqualTo("hold");
        TestHttpClient viewer = tenant.http(Role.VIEWER);
        assertThat(viewer.get(ZONES).json().path("features").get(0)).isEqualTo(added.json());
        // What was read can be written again.
        TestHttpClient.Answer again =
                put(added.text("id"), added.json().toString().replace("School", "Hospital"));
        assertThat(again.json().path("properties").path("name").asString()).isEqualTo("Hospital");
        assertThat(delete(added.text("id")).status()).isEqualTo(204);
        assertThat(delete(added.text("id")).status()).isEqualTo(404);
        assertThat(viewer.get(ZONES).json().path("features").size()).isZero();
    }

    @Test
    void makesTheZonesThatAVehicleCanKeepItsOwnFence() {
        String path = "/api/v1/drones/" + vehicle.id() + "/fence/zones";
        TestHttpClient planner = tenant.http(Role.PLANNER);
        HttpRequest.BodyPublisher nothing = HttpRequest.BodyPublishers.noBody();
        assertThat(planner.send(path, request -> request.PUT(nothing)).text("detail"))
                .startsWith("No zone without floor and ceiling binds this drone now");
        supervisor.post(ZONES, feature(NORTH, "\"name\":\"School\""));
        supervisor.post(ZONES, feature(NORTH, "\"name\":\"Low\",\"ceiling\":80"));
        supervisor.post(ZONES, feature(NORTH, "\"name\":\"Later\",\"from\":\"2098-01-01T00:00:00Z\""));

        TestHttpClient.Answer sent = planner.send(path, request -> request.PUT(nothing));

        assertThat(sent.json().path("warnings").size()).isEqualTo(1);
        assertThat(sent.json().path("warnings").get(0).asString()).contains("“Low”");
        await().untilAsserted(() -> assertThat(vehicle.performed())
                .filteredOn(SetFence.class::isInstance)
                .singleElement()
                .satisfies(command -> assertThat(((SetFence) command).zones()).hasSize(1)));
    }

    @Test
    void letsOnlySupervisorsChangeZones() {
        assertThat(operator.post(ZONES, feature(NORTH, "\"name\":\"A\"")).status())
                .isEqualTo(403);
        assertThat(operator.post(ZONES + "/import", feature(NORTH, "\"name\":\"A\""))
                        .status())
                .isEqualTo(403);
        String id = supervisor.post(ZONES, feature(NORTH, "\"name\":\"A\"")).text("id");
        assertThat(operator.send(ZONES + "/" + id, HttpRequest.Builder::DELETE).status())
                .isEqualTo(403);
    }

    @Test
    void saysWhatIsWrongWithAZone() {
        assertWrong(feature(NORTH, "\"name\":\" \""), "properties.name", "missing");
        assertWrong(
                feature("[[[8.5,47],[8.6,47],[8.5,47]]]", "\"name\":\"A\""), "geometry.coordinates[0]", "3 to 1000");
        assertWrong(
                feature("[[[8.5,95],[8.6,47],[8.7,48]]]", "\"name\":\"A\""), "geometry.coordinates[0][0][1]", "-90");
        assertWrong(
                feature("[[[8.5,47],[8.51,47.01],[8.51,47],[8.5,47.01],[8.5,47]]]", "\"name\":\"A\""),
                "geometry",
                "crosses or touches itself");
        assertWrong(
                feature(NORTH, "\"name\":\"A\",\"floor\":50,\"ceiling\":20"), "properties.ceiling", "above the floor");
        assertWrong(feature(NORTH, "\"name\":\"A\",\"user\":\"nobody\""), "properties.user", "the name of a user");
        assertWrong(feature(NORTH, "\"name\":\"A\",\"drone\":\"nobody-1\""), "properties.drone", "the id of a drone");
        assertWrong(feature(NORTH, "\"name\":\"A\",\"from\":\"noon\""), "properties.from", "a time such as");
        assertWrong(
                feature(NORTH, "\"name\":\"A\",\"until\":\"2020-01-01T00:00:00Z\""),
                "properties.until",
                "later than now");
        assertWrong(feature("[]", "\"name\":\"A\""), "geometry.coordinates", "one ring of positions, not none");
        assertWrong(feature("\"here\"", "\"name\":\"A\""), "geometry.coordinates", "a list");
        assertWrong(feature("[[[8.5,\"east\"]]]", "\"name\":\"A\""), "geometry.coordinates[0][0][1]", "a number");
        assertWrong(
                feature(NORTH, "\"name\":\"A\"").replace("Polygon\"", "Polygon\",\"radius\":5"),
                "geometry.radius",
                "there are: type, coordinates.");
        assertWrong(
                feature(NORTH, "\"name\":\"A\"").replace("Polygon", "LineString"),
                "geometry.type",
                "Polygon or Point, not \"LineString\"");
        assertWrong(feature(NORTH, "\"name\":\"A\",\"onBreach\":\"explode\""), "properties.onBreach", "hold");
        assertWrong(
                "{\"type\":\"Feature\",\"geometry\":{\"type\":\"Point\",\"coordinates\":[8.5,47]},"
                        + "\"properties\":{\"name\":\"A\"}}",
                "properties.radius",
                "1 to 100000 m");
        assertThat(house.cloud().zones().zones())
                .noneMatch(zone -> zone.organisation().equals(tenant.organisation()));
    }

    @Test
    void saysWhereAFileOfAnotherProgramHasNothing() {
        for (String coordinates : List.of("[null]", "[[null]]", "[[[8.5,null]]]", "null")) {
            TestHttpClient.Answer answer = supervisor.post(ZONES + "/import", feature(coordinates, "\"name\":\"A\""));
            assertThat(answer.status()).as(coordinates).isEqualTo(422);
            assertThat(answer.text("field")).startsWith("geometry.coordinates");
        }
        TestHttpClient.Answer several = supervisor.post(
                ZONES + "/import", feature("[null]", "\"name\":\"A\"").replace("Polygon", "MultiPolygon"));
        assertThat(several.text("field")).isEqualTo("geometry.coordinates");
    }

    @Test
    void haveTheirRingsAsItemsInSoap() {
        SoapClient soap = SoapClient.withKey(house, tenant.key(Role.SUPERVISOR));
        List<List<Double>> ring =
                List.of(List.of(8.544, 47.4), List.of(8.547, 47.4), List.of(8.547, 47.402), List.of(8.544, 47.4));

        SoapClient.Answer added = soap.call(
                "addZone",
                "type",
                "Feature",
                "geometry",
                Map.of("Polygon", Map.of("coordinates", List.of(ring))),
                "properties",
                Map.of("name", "A corner"));

        assertThat(added.texts("geometry.Polygon.coordinates.item.item.item"))
                .containsExactly("8.544", "47.4", "8.547", "47.4", "8.547", "47.402", "8.544", "47.4");
        assertThat(supervisor
                        .get(ZONES + "/" + added.text("id"))
                        .json()
                        .at("/geometry/coordinates")
                        .toString())
                .isEqualTo("[[[8.544,47.4],[8.547,47.4],[8.547,47.402],[8.544,47.4]]]");
    }

    @Test
    void takesAFileOfAnotherProgramWholeOrNotAtAll() {
        String foreign = "{\"type\":\"FeatureCollection\",\"crs\":{\"a\":1},\"features\":["
                + "{\"type\":\"Feature\",\"id\":7,\"geometry\":{\"type\":\"MultiPolygon\",\"coordinates\":[" + NORTH
                + ","
                + HERE + "]},\"properties\":{\"colour\":\"red\",\"name\":\"Park\"}},"
                + "{\"type\":\"Feature\",\"geometry\":{\"type\":\"Polygon\",\"coordinates\":" + NORTH
                + "},\"properties\":null}]}";

        TestHttpClient.Answer taken = supervisor.post(ZONES + "/import", foreign);
        TestHttpClient.Answer inPart =
                supervisor.post(ZONES + "/import", foreign.replace("\"Polygon\"", "\"LineString\""));
        TestHttpClient.Answer nothing = supervisor.post(
                ZONES + "/import",
                foreign.replace("\"Polygon\"", "\"LineString\"").replace("\"MultiPolygon\"", "\"LineString\""));

        assertThat(taken.status()).isEqualTo(201);
        assertThat(taken.json()
                        .path("features")
                        .valueStream()
                        .map(zone -> zone.path("properties").path("name").asString()))
                .containsExactly("Park (1)", "Park (2)", "Zone 2");
        assertThat(taken.json().path("leftOut").isEmpty()).isTrue();
        assertThat(inPart.status()).isEqualTo(201);
        assertThat(inPart.json().path("features").size()).isEqualTo(2);
        assertThat(inPart.json().path("leftOutTotal").asInt()).isEqualTo(1);
        assertThat(inPart.json().path("leftOut").get(0).path("at").asString()).isEqualTo("features[1]");
        assertThat(inPart.json().path("leftOut").get(0).path("code").asString()).isEqualTo("value-not-allowed");
        assertThat(inPart.json().path("leftOut").get(0).path("why").asString()).contains("\"LineString\"");
        assertThat(nothing.status()).isEqualTo(422);
        assertThat(nothing.text("detail")).startsWith("None of the 2 pieces of this file can be a zone.");
        assertThat(supervisor.get(ZONES).json().path("features").size()).isEqualTo(5);
    }

    @Test
    void takesTheAreasOfAKmlFile() {
        String kml = "<?xml version=\"1.0\"?><kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document><name>All</name>"
                + "<Placemark><name>Lake &amp; shore</name><Polygon><outerBoundaryIs><LinearRing><coordinates>"
                + "8.5,47,0 8.6,47,0 8.6,47.1,0\n8.5,47,0</coordinates></LinearRing></outerBoundaryIs></Polygon>"
                + "</Placemark><Placemark><Point><coordinates>8,47</coordinates></Point></Placemark></Document></kml>";

        TestHttpClient.Answer taken = supervisor.post(ZONES + "/import", kml);
        TestHttpClient.Answer evil = supervisor.post(
                ZONES + "/import", "<!DOCTYPE kml [<!ENTITY x SYSTEM \"file:///etc/passwd\">]><kml>&x;</kml>");
        TestHttpClient.Answer empty = supervisor.post(ZONES + "/import", "<kml/>");

        assertThat(taken.status()).isEqualTo(201);
        assertThat(taken.json()
                        .path("features")
                        .get(0)
                        .path("properties")
                        .path("name")
                        .asString())
                .isEqualTo("Lake & shore");
        assertThat(evil.status()).isEqualTo(400);
        assertThat(empty.text("detail")).isEqualTo("There is no area in this file.");
    }

    @Test
    void refusesAWayThroughAZoneBeforeAnythingIsSent() {
        supervisor.post(ZONES, feature(NORTH, "\"name\":\"School\""));
        fly();

        TestHttpClient.Answer refused = operator.post(
                "/api/v1/drones/" + vehicle.id() + "/commands",
                "{\"type\":\"goTo\",\"latitude\":47.404,\"longitude\":8.5456,\"altitude\":20}");

        assertThat(refused.status()).isEqualTo(409);
        assertThat(refused.text("detail"))
                .isEqualTo("The way from where the drone is to the place enters the no-fly zone “School” after 256 m.");
        assertThat(vehicle.performed()).isEmpty();
    }

    @Test
    void tellsADroneToHoldWhenAZoneIsPutOverIt() {
        fly();

        supervisor.post(ZONES, feature(HERE, "\"name\":\"Accident\""));

        await().atMost(Duration.ofSeconds(30)).until(() -> vehicle.performed().contains(new Command.Hold()));
        await().until(() -> operator.get("/api/v1/drones/" + vehicle.id())
                .json()
                .path("messages")
                .toString()
                .contains("It has entered the no-fly zone “Accident” and is told: hold."));
        assertThat(operator.get("/api/v1/drones/" + vehicle.id() + "/commands")
                        .json()
                        .path("commands")
                        .get(0)
                        .path("face")
                        .asString())
                .isEqualTo("safety");
    }

    @Test
    void tellsEverybodyWhoListens() {
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, tenant.key(Role.VIEWER))) {
            stream.await(message -> isType(message, "drones"));
            String id = supervisor
                    .post(ZONES, feature(NORTH, "\"name\":\"School\""))
                    .text("id");

            assertThat(stream.await(message -> isType(message, "zone"))
                            .path("zone")
                            .path("id")
                            .asString())
                    .isEqualTo(id);
            delete(id);
            assertThat(stream.await(message -> isType(message, "zoneRemoved"))
                            .path("id")
                            .asString())
                    .isEqualTo(id);
        }
    }

    @Test
    void showsZonesOfADroneToThoseAloneWhoSeeIt() {
        String own = "\"name\":\"Its own\",\"drone\":\"" + vehicle.id() + "\"";
        String id = supervisor.post(ZONES, feature(NORTH, own)).text("id");
        KeyScope another = new KeyScope(Set.of(new DroneId("another-1")), EnumSet.allOf(Permission.class));
        String key = tenant.key(new KeyRights(Role.OPERATOR, another, null));
        TestHttpClient blind = new TestHttpClient(house, key);

        assertThat(blind.get(ZONES).json().path("features").size()).isZero();
        assertThat(blind.get(ZONES + "/" + id).status()).isEqualTo(404);
        assertThat(operator.get(ZONES).json().path("features").size()).isEqualTo(1);
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, key)) {
            stream.await(message -> isType(message, "drones"));
            supervisor.post(ZONES, feature(HERE, own));
            supervisor.post(ZONES, feature(NORTH, "\"name\":\"Everybody's\""));
            stream.await(message -> isType(message, "zone"));

            assertThat(stream.heard().toString()).contains("Everybody's").doesNotContain("Its own", vehicle.id());
        }
    }

    private static boolean isType(JsonNode message, String type) {
        return message.path("type").asString().equals(type);
    }

    private void fly() {
        vehicle.says(new DroneEvent.ModeReported("GUIDED", true));
        vehicle.says(new DroneEvent.PositionReported(new Position(new Geodetic(47.3977, 8.5456), 508.0, 20.0)));
        vehicle.says(new DroneEvent.PhaseReported(FlightPhase.IN_AIR));
        await().until(() ->
                "inAir".equals(operator.get("/api/v1/drones/" + vehicle.id()).text("flight")));
    }

    private void assertWrong(String body, String field, String words) {
        TestHttpClient.Answer answer = supervisor.post(ZONES, body);
        assertThat(answer.status()).as(body).isEqualTo(422);
        assertThat(answer.text("field")).isEqualTo(field);
        assertThat(answer.text("detail")).contains(words);
    }

    private static String feature(String coordinates, String properties) {
        return "{\"type\":\"Feature\",\"geometry\":{\"type\":\"Polygon\",\"coordinates\":" + coordinates
                + "},\"properties\":{" + properties + "}}";
    }

    private TestHttpClient.Answer put(String id, String body) {
        return supervisor.send(
                ZONES + "/" + id,
                builder -> builder.header("Content-Type", "application/json")
                        .PUT(HttpRequest.BodyPublishers.ofString(body)));
    }

    private TestHttpClient.Answer delete(String id) {
        return supervisor.send(ZONES + "/" + id, HttpRequest.Builder::DELETE);
    }
}
