package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.StringReader;
import java.net.http.HttpRequest;
import java.nio.ByteBuffer;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import javax.xml.parsers.DocumentBuilderFactory;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.session.FrameTap;
import org.dronemap.ws.testserver.ConditionWait;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.SoapClient;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.w3c.dom.Document;
import org.xml.sax.InputSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Flights and telemetry over REST: found, looked at, taken along as files, and noted upon by those who may. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class FlightsTest {
    private static final String PATH = "/api/v1/flights";
    /** The time, and a heartbeat. */
    private static final int RECORD_BYTES = 8 + 21;

    private static final String MESSAGE = "EKF <failsafe> & \"compass\"";

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestServer house = tenant.server();
    private TestHttpClient viewer;
    private TestHttpClient operator;
    private ScriptedVehicle vehicle;
    private String id;
    private FrameTap wire;

    @BeforeAll
    void fly() {
        viewer = tenant.http(Role.VIEWER);
        operator = tenant.http(Role.OPERATOR);
        vehicle = tenant.vehicle();
        wire = house.recorder().open(1);
        wire.bound(new DroneId(vehicle.id()));
        heardOnTheWire();
        vehicle.says(new DroneEvent.BatteryReported(new Battery(90, 12.6, null)));
        assertThat(operator.post("/api/v1/drones/" + vehicle.id() + "/commands?wait=30", "{\"type\":\"arm\"}")
                        .status())
                .isEqualTo(200);
        vehicle.says(new DroneEvent.ModeReported("GUIDED", true));
        vehicle.says(new DroneEvent.PositionReported(new Position(new Geodetic(47.3987, 8.5456), 508.0, 20.0)));
        vehicle.says(new DroneEvent.TextReported(Severity.CRITICAL, MESSAGE));
        vehicle.says(new DroneEvent.BatteryReported(new Battery(70, 12.1, null)));
        ConditionWait.until(
                "the flight is known",
                () -> Optional.of(newest())
                        .filter(flight -> flight.path("state").asString().equals("running")));
        heardOnTheWire();
        vehicle.says(new DroneEvent.ModeReported("GUIDED", false));
        id = ConditionWait.until(
                "the flight has ended",
                () -> Optional.of(newest())
                        .filter(flight -> flight.path("state").asString().equals("ended"))
                        .map(flight -> flight.path("id").asString()));
        ConditionWait.until("its points are kept", () -> points().size() >= 2 ? Optional.of(true) : Optional.empty());
        Instant end = Instant.parse(viewer.get(PATH + "/" + id).text("end"));
        ConditionWait.until(
                "time has passed",
                () -> Optional.of(end).filter(at -> Instant.now().isAfter(at.plusMillis(5))));
        heardOnTheWire();
    }

    private void heardOnTheWire() {
        byte[] heartbeat = new FrameWriter(1, 1, 2).frame(new Heartbeat(2, 3, 0x81, 4, 4, 3));
        new FrameReader().read(ByteBuffer.wrap(heartbeat), wire::received);
    }

    @Test
    void nobodySeesThemWithoutSigningIn() {
        assertThat(new TestHttpClient(house, "").get(PATH).status()).isEqualTo(401);
    }

    @Test
    void tellsWhoFlewHowFarAndOnWhatCharge() {
        JsonNode flight = viewer.get(PATH + "/" + id).json();

        assertThat(flight.path("drone").asString()).isEqualTo(vehicle.id());
        assertThat(flight.path("users").path(0).asString()).isEqualTo(nameOf(operator));
        assertThat(flight.path("distance").asDouble()).isBetween(110.0, 113.0);
        assertThat(flight.path("highest").asDouble()).isEqualTo(20);
        assertThat(flight.path("battery").path("used").asInt()).isEqualTo(20);
        assertThat(Instant.parse(flight.path("end").asString()))
                .isAfterOrEqualTo(Instant.parse(flight.path("start").asString()));
    }

    @Test
    void findsFlightsAndRefusesWhatCannotBeLookedFor() {
        assertThat(found("?drone=" + vehicle.id())).isPositive();
        assertThat(found("?drone=another")).isZero();
        assertThat(found("?user=" + nameOf(operator))).isPositive();
        assertThat(found("?from=2020-01-01T00:00:00Z&until=2021-01-01T00:00:00Z"))
                .isZero();
        assertThat(found("?words=copter")).isPositive();
        assertThat(viewer.get(PATH + "?from=yesterday").text("field")).isEqualTo("from");
        assertThat(viewer.get(PATH + "?limit=0").text("field")).isEqualTo("limit");
        assertThat(viewer.get(PATH + "?before=nosuchflight").text("field")).isEqualTo("before");
        assertThat(viewer.get(PATH + "?drone=Not%20An%20Id").text("field")).isEqualTo("drone");
        for (String what : List.of("/events", "/telemetry", "/telemetry/points")) {
            assertThat(viewer.get(PATH + "/" + id + what + "?from=yesterday").text("field"))
                    .isEqualTo("from");
        }
    }

    @Test
    void tellsWhatHappenedWithTheOutcomesOfCommands() {
        ConditionWait.until("the command is told", () -> {
            String events = viewer.get(PATH + "/" + id + "/events").raw().body();
            return events.contains("\"result\":\"succeeded\"") ? Optional.of(true) : Optional.empty();
        });
        JsonNode events = viewer.get(PATH + "/" + id + "/events").json().path("events");

        assertThat(events.valueStream().map(event -> event.path("kind").asString()))
                .contains("armed", "disarmed", "message", "command");
        assertThat(events.valueStream().map(event -> event.path("text").asString()))
                .contains(MESSAGE);
        assertThat(viewer.get("/api/v1/drones/" + vehicle.id() + "/events")
                        .raw()
                        .body())
                .contains("armed");
    }

    @Test
    void givesNumbersOverTimeWithTheirPeaks() {
        JsonNode series = viewer.get(PATH + "/" + id + "/telemetry?fields=altitudeAboveHome,batteryPercent&slots=1")
                .json();

        assertThat(series.path("times").size()).isEqualTo(1);
        JsonNode height = series.path("fields").path(0);
        assertThat(height.path("name").asString()).isEqualTo("altitudeAboveHome");
        assertThat(height.path("unit").asString()).isEqualTo("m");
        assertThat(height.path("least").path(0).asDouble()).isZero();
        assertThat(height.path("most").path(0).asDouble()).isEqualTo(20);
        String ofDrone = "/api/v1/drones/" + vehicle.id() + "/telemetry";
        assertThat(viewer.get(ofDrone).json().path("fields").size()).isEqualTo(4);
        assertThat(viewer.get(ofDrone + "?fields=wings").text("field")).isEqualTo("fields");
        assertThat(viewer.get(ofDrone + "?slots=5001").text("field")).isEqualTo("slots");
        assertThat(viewer.get(ofDrone + "?slots=many").text("field")).isEqualTo("slots");
        assertThat(viewer.get(ofDrone + "?from=2020-01-01T00:00:00Z").text("field"))
                .isEqualTo("from");
        assertThat(viewer.get(ofDrone + "?from=2020-01-02T00:00:00Z&until=2020-01-01T00:00:00Z")
                        .text("field"))
                .isEqualTo("until");
    }

    @Test
    void givesNoMorePointsThanAreAskedFor() {
        assertThat(points()).hasSizeGreaterThanOrEqualTo(2);
        assertThat(viewer.get(PATH + "/" + id + "/telemetry/points?most=1")
                        .json()
                        .path("points")
                        .size())
                .isEqualTo(1);
        assertThat(viewer.get("/api/v1/drones/" + vehicle.id() + "/telemetry/points?most=0")
                        .text("field"))
                .isEqualTo("most");
    }

    @Test
    void givesTheTrackAsATable() {
        TestHttpClient.Answer file = viewer.get(PATH + "/" + id + "/telemetry/file");
        String[] lines = file.raw().body().split("\r\n");

        assertThat(lines).hasSize(points().size() + 1);
        assertThat(lines[0]).startsWith("\"at\",\"latitude\",\"longitude\"");
        assertThat(lines[lines.length - 1])
                .contains("47.3987,8.5456,508.0,20.0")
                .contains("\"GUIDED\"");
        assertThat(file.raw().headers().firstValue("Content-Disposition"))
                .hasValueSatisfying(value -> assertThat(value).endsWith(".csv\""));
        assertThat(viewer.get(PATH + "/" + id + "/telemetry/file?form=doc").text("field"))
                .isEqualTo("form");
    }

    @Test
    void givesTheTrackAsGeoJson() {
        JsonNode all = JsonMapper.shared().readTree(file("geojson"));
        JsonNode line = all.path("features").path(0);

        assertThat(line.path("geometry").path("type").asString()).isEqualTo("LineString");
        assertThat(line.path("geometry")
                        .path("coordinates")
                        .path(points().size() - 1)
                        .toString())
                .isEqualTo("[8.5456,47.3987,508.0]");
        assertThat(line.path("properties").path("coordTimes").size()).isEqualTo(points().size());
        assertThat(all.path("features")
                        .valueStream()
                        .map(one -> one.path("properties").path("name").asString()))
                .contains(MESSAGE);
    }

    @Test
    void givesTheTrackAsKmlGpxAndColumns() throws Exception {
        Document kml = xml(file("kml"));
        assertThat(kml.getElementsByTagName("gx:coord")
                        .item(points().size() - 1)
                        .getTextContent())
                .isEqualTo("8.5456 47.3987 508.0");
        assertThat(kml.getElementsByTagName("when").getLength()).isGreaterThanOrEqualTo(2);
        assertThat(kml.getDocumentElement().getTextContent()).contains(MESSAGE);
        Document gpx = xml(file("gpx"));
        assertThat(gpx.getElementsByTagName("trkpt").getLength()).isEqualTo(points().size());
        assertThat(gpx.getElementsByTagName("ele").item(points().size() - 1).getTextContent())
                .isEqualTo("508.0");
        assertThat(file("parquet")).startsWith("PAR1").endsWith("PAR1");
    }

    @Test
    void givesWhatWasOnTheWireWhereItWasRecorded() {
        TestHttpClient.Answer one = ConditionWait.until(
                "it is recorded",
                () -> Optional.of(viewer.get(PATH + "/" + id + "/telemetry/file?form=tlog"))
                        .filter(answer -> answer.status() == 200));
        assertThat(one.raw().headers().firstValue("Content-Length")).contains("" + RECORD_BYTES);
        assertThat(one.raw().headers().firstValue("Content-Disposition"))
                .hasValueSatisfying(value -> assertThat(value).endsWith(".tlog\""));
        assertThat(viewer.get("/api/v1/drones/" + vehicle.id() + "/telemetry/file?form=tlog")
                        .raw()
                        .headers()
                        .firstValue("Content-Length"))
                .contains("" + 3 * RECORD_BYTES);
        TestHttpClient.Answer none = viewer.get("/api/v1/drones/" + vehicle.id()
                + "/telemetry/file?form=tlog&from=2026-01-01T00:00:00Z&until=2026-01-01T01:00:00Z");
        assertThat(none.status()).isEqualTo(409);
        assertThat(none.text("detail")).startsWith("There is no recording of that drone at that time");
    }

    @Test
    void givesFlightsThroughSoap() {
        SoapClient soap = SoapClient.withKey(house, tenant.key(Role.VIEWER));

        SoapClient.Answer flight = soap.call("getFlight", "flightId", id);
        assertThat(flight.text("drone")).isEqualTo(vehicle.id());
        assertThat(flight.text("state")).isEqualTo("ended");
        assertThat(flight.text("battery.used")).isEqualTo("20");
        assertThat(flight.texts("users.item")).containsExactly(nameOf(operator));
        assertThat(soap.call("listFlights", "drone", vehicle.id()).texts("flights.item.id"))
                .contains(id);
        assertThat(soap.call("listFlights", "user", "nobody").texts("flights.item"))
                .isEmpty();
        assertThatThrownBy(() -> soap.call("listFlights", "from", "yesterday")).hasMessageContaining("from");
        assertThatThrownBy(() -> soap.call("getFlight", "flightId", "nosuchflight"))
                .hasMessageContaining("There is no flight");
    }

    @Test
    void saysWhenTheStoreIsAwayAndDronesGoOn() {
        // What is remembered of all drones is for those who run the server.
        TestHttpClient administrator = new TestHttpClient(house, house.key(Role.ADMINISTRATOR));
        SoapClient soap = SoapClient.withKey(house, tenant.key(Role.VIEWER));
        ScriptedVehicle other = tenant.vehicle();
        house.historyStores().off();
        try {
            for (String path : List.of("", "/" + id, "/" + id + "/telemetry", "/" + id + "/events", "/logbook")) {
                TestHttpClient.Answer answer = viewer.get(PATH + path);
                assertThat(answer.status()).as(path).isEqualTo(503);
                assertThat(answer.text("type")).as(path).isEqualTo("urn:dronemap:problem:unavailable");
                assertThat(answer.raw().body()).as(path).doesNotContain("switched");
            }
            assertThatThrownBy(() -> soap.call("getFlight", "flightId", id)).hasMessageContaining("cannot be reached");
            other.says(new DroneEvent.TextReported(Severity.INFO, "on the ground"));
            TestHttpClient.Answer health = ConditionWait.until(
                    "it is told",
                    () -> Optional.of(viewer.get("/api/v1/health"))
                            .filter(answer -> answer.text("history").equals("down")));
            assertThat(health.text("status")).isEqualTo("degraded");
            TestHttpClient.Answer status = administrator.get("/api/v1/history");
            assertThat(status.json().path("up").asBoolean(true)).isFalse();
            assertThat(status.text("trouble")).contains("switched off");
            assertThat(operator.post("/api/v1/drones/" + other.id() + "/commands?wait=30", "{\"type\":\"arm\"}")
                            .status())
                    .isEqualTo(200);
        } finally {
            house.historyStores().on();
        }
        TestHttpClient.Answer again = ConditionWait.until(
                "all is well",
                () -> Optional.of(administrator.get("/api/v1/history"))
                        .filter(answer -> answer.json().path("up").asBoolean(false)));
        assertThat(again.text("server")).isEqualTo("memory");
        assertThat(again.json().path("dropped").asLong(-1)).isZero();
        assertThat(viewer.get(PATH + "/" + id).status()).isEqualTo(200);
        assertThat(new TestHttpClient(house, house.key(Role.VIEWER))
                        .get("/api/v1/history")
                        .status())
                .isEqualTo(403);
    }

    @Test
    void givesTheLogbook() {
        String logbook =
                viewer.get(PATH + "/logbook?drone=" + vehicle.id()).raw().body();

        assertThat(logbook.split("\r\n")).hasSize(2);
        assertThat(logbook).contains("\"" + id + "\"").contains("\"" + nameOf(operator) + "\"");
        assertThat(viewer.get(PATH + "/logbook?drone=another").raw().body().split("\r\n"))
                .hasSize(1);
    }

    @Test
    void keepsTheNotesOfThoseWhoMayCommand() {
        String path = PATH + "/" + id;
        assertThat(patch(viewer, path, "{\"notes\":\"mine\"}").status()).isEqualTo(403);
        assertThat(patch(operator, path, "{}").text("field")).isEqualTo("notes");
        assertThat(patch(operator, path, "{\"notes\":\"" + "x".repeat(4_001) + "\"}")
                        .text("field"))
                .isEqualTo("notes");
        assertThat(patch(operator, path, "{\"notes\":\"windy\"}").text("notes")).isEqualTo("windy");
        assertThat(viewer.get(path).text("notes")).isEqualTo("windy");
        assertThat(found("?words=WINDY")).isEqualTo(1);
    }

    @Test
    void hidesThemFromOtherOrganisations() {
        try (TestTenant others = new TestTenant()) {
            TestHttpClient stranger = others.http(Role.ADMINISTRATOR);

            assertThat(stranger.get(PATH).json().path("flights").size()).isZero();
            assertThat(stranger.get(PATH + "/" + id).status()).isEqualTo(404);
            assertThat(stranger.get(PATH + "/" + id + "/telemetry/points").status())
                    .isEqualTo(404);
            assertThat(stranger.get("/api/v1/drones/" + vehicle.id() + "/telemetry")
                            .status())
                    .isEqualTo(404);
            assertThat(stranger.get(PATH + "/logbook").raw().body().split("\r\n"))
                    .hasSize(1);
        }
    }

    @Test
    void healthSaysThatAllIsRemembered() {
        assertThat(viewer.get("/api/v1/health").text("history")).isEqualTo("up");
    }

    private JsonNode newest() {
        return viewer.get(PATH + "?drone=" + vehicle.id())
                .json()
                .path("flights")
                .path(0);
    }

    private JsonNode points() {
        return viewer.get(PATH + "/" + id + "/telemetry/points").json().path("points");
    }

    private int found(String search) {
        return viewer.get(PATH + search).json().path("flights").size();
    }

    private String file(String form) {
        return viewer.get(PATH + "/" + id + "/telemetry/file?form=" + form)
                .raw()
                .body();
    }

    private static String nameOf(TestHttpClient who) {
        return who.get("/api/v1/session").text("name");
    }

    private static Document xml(String text) throws Exception {
        return DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(new InputSource(new StringReader(text)));
    }

    private static TestHttpClient.Answer patch(TestHttpClient who, String path, String body) {
        return who.send(
                path,
                request -> request.header("Content-Type", "application/json")
                        .method("PATCH", HttpRequest.BodyPublishers.ofString(body)));
    }
}
