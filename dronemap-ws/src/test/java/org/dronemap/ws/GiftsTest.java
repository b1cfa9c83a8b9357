package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.nio.ByteBuffer;
import java.time.Instant;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.link.RobotKey;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.session.FrameTap;
import org.dronemap.ws.robotkey.RobotKeyFixture;
import org.dronemap.ws.testserver.ConditionWait;
import org.dronemap.ws.testserver.OrganisationMember;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.SharedServer;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;

/** A drone that is given to another organisation: what goes along, what stays, and how it comes back. */
class GiftsTest {
    private static final String FLIGHTS = "/api/v1/flights";
    private static final String RECORDINGS = "/api/v1/recordings";
    private static final String OTHERS = "another organisation";

    private final TestServer house = SharedServer.get();
    private final ScriptedVehicle kite = ScriptedVehicle.connect(house.cloud(), 20_000 + house.number());
    private final OrganisationMember root =
            house.member(OrganisationId.HOME, "root-" + house.number(), Role.ADMINISTRATOR);
    private final OrganisationMember ann = house.member(OrganisationId.HOME, "ann-" + house.number(), Role.SUPERVISOR);
    private final String rescue = root.http()
            .post("/api/v1/organisations", "{\"name\":\"Mountain rescue " + house.number() + "\"}")
            .text("id");
    private final OrganisationMember bea =
            house.member(new OrganisationId(rescue), "bea-" + house.number(), Role.ADMINISTRATOR);
    private final String gift = "/api/v1/organisations/" + rescue + "/drones/" + kite.id();
    private final String drone = "/api/v1/drones/" + kite.id();

    @Test
    void takesNothingAlongUnlessThatIsSaid() {
        Deed annes = fly(ann);

        TestHttpClient.Answer given = put(gift, "");

        assertThat(given.status()).isEqualTo(200);
        assertThat(given.json().path("histories").asBoolean()).isFalse();
        assertThat(given.text("notice")).contains("do not go along");
        assertThat(bea.http().get(drone).status()).isEqualTo(200);
        assertThat(ann.http().get(drone).status()).isEqualTo(404);
        assertThat(found(bea, "")).isEmpty();
        for (String path : annes.paths()) {
            assertThat(bea.http().get(path).status()).as(path).isEqualTo(404);
            assertThat(ann.http().get(path).status()).as(path).isEqualTo(200);
        }
        assertThat(found(ann, "")).containsExactly(annes.flight());
        assertThat(whatShows(bea)).doesNotContain(ann.name()).doesNotContain(annes.command());
        Instant from = Instant.parse(given.text("at"));
        assertThat(Instant.parse(bea.http().get(drone + "/events").text("from")))
                .isEqualTo(from);
        TestHttpClient.Answer early = bea.http().get(drone + "/telemetry?from=" + from.minusSeconds(1));
        assertThat(early.status()).isEqualTo(422);
        assertThat(early.text("detail")).startsWith("The drone was another organisation's then; ask from ");
    }

    @Test
    void takesAlongWhatItDidAndNobodysName() {
        Deed annes = fly(ann);
        assertThat(put(gift, "{\"histories\":true}").json().path("histories").asBoolean())
                .isTrue();

        assertThat(found(bea, "")).containsExactly(annes.flight());
        JsonNode flight = bea.http().get(FLIGHTS + "/" + annes.flight()).json();
        assertThat(flight.path("users").valueStream().map(JsonNode::asString)).containsExactly(OTHERS);
        assertThat(flight.path("notes").asString()).isEmpty();
        assertThat(bea.http().get("/api/v1/commands/" + annes.command()).text("by"))
                .isEqualTo(OTHERS);
        for (String path : annes.paths()) {
            TestHttpClient.Answer shown = bea.http().get(path);
            assertThat(shown.status()).as(path).isEqualTo(200);
            assertThat(shown.raw().body()).as(path).doesNotContain(ann.name());
        }
        assertThat(whatShows(bea)).doesNotContain(ann.name()).contains(annes.command());
        assertThat(found(bea, "&user=" + ann.name())).isEmpty();
        assertThat(found(bea, "&words=secret")).isEmpty();
        assertThat(found(ann, "&words=secret")).containsExactly(annes.flight());
        String recording = RECORDINGS + "/" + annes.recording();
        assertThat(bea.http().get(recording + "/sent").status()).isEqualTo(409);
        assertThat(bea.http()
                        .send(recording + "?confirm=true", HttpRequest.Builder::DELETE)
                        .status())
                .isEqualTo(409);
        assertThat(patch(bea, FLIGHTS + "/" + annes.flight(), "{\"notes\":\"ours\"}")
                        .status())
                .isEqualTo(409);
    }

    @Test
    void comesBackWithoutWhatItDidMeanwhile() {
        Deed annes = fly(ann);
        put(gift, "");
        Deed beas = fly(bea);
        assertThat(root.http()
                        .get("/api/v1/organisations/" + rescue + "/drones")
                        .json()
                        .path("gifts")
                        .findValuesAsString("drone"))
                .containsExactly(kite.id());

        TestHttpClient.Answer back = root.http().send(gift, HttpRequest.Builder::DELETE);

        assertThat(back.status()).isEqualTo(200);
        assertThat(back.text("to")).isEqualTo(OrganisationId.HOME.value());
        assertThat(ann.http().get(drone).status()).isEqualTo(200);
        assertThat(bea.http().get(drone).status()).isEqualTo(404);
        assertThat(found(ann, "")).containsExactly(annes.flight());
        assertThat(found(bea, "")).containsExactly(beas.flight());
        for (String path : beas.paths()) {
            assertThat(ann.http().get(path).status()).as(path).isEqualTo(404);
        }
        Instant begun =
                Instant.parse(ann.http().get(FLIGHTS + "/" + annes.flight()).text("start"));
        assertThat(ann.http().get(drone + "/events?from=" + begun).status()).isEqualTo(422);
        assertThat(whatShows(ann)).doesNotContain(bea.name()).doesNotContain(beas.command());
        assertThat(root.http().send(gift, HttpRequest.Builder::DELETE).status()).isEqualTo(404);
    }

    @Test
    void isRefusedWhileSomethingHasTheDrone() {
        kite.says(new DroneEvent.ModeReported("GUIDED", true));
        assertThat(put(gift, "").text("detail")).startsWith("It is armed or in the air");
        kite.says(new DroneEvent.PhaseReported(FlightPhase.IN_AIR));
        kite.says(new DroneEvent.ModeReported("GUIDED", false));
        assertThat(put(gift, "").status()).isEqualTo(409);
        kite.says(new DroneEvent.PhaseReported(FlightPhase.ON_GROUND));
        String place = "/api/v1/warehouse/" + kite.id();
        assertThat(ann.http()
                        .send(place, request -> request.PUT(HttpRequest.BodyPublishers.noBody()))
                        .status())
                .isEqualTo(200);
        assertThat(put(gift, "").text("detail")).contains("warehouse");
        ann.http().send(place, HttpRequest.Builder::DELETE);

        assertThat(put(gift, "").status()).isEqualTo(200);

        kite.says(new DroneEvent.ModeReported("GUIDED", true));
        assertThat(root.http().send(gift, HttpRequest.Builder::DELETE).status()).isEqualTo(409);
        kite.says(new DroneEvent.ModeReported("GUIDED", false));
    }

    @Test
    void endsTheControlOfWhoHadItAndNamesNobody() {
        assertThat(ann.http().post(drone + "/control/take", "").status()).isEqualTo(200);

        put(gift, "");

        assertThat(bea.http().get(drone).json().at("/control/state").asString()).isEqualTo("free");
        ConditionWait.until(
                "the end of control is told",
                () -> Optional.of(house.records())
                        .filter(records -> records.toString().contains(ann.name())));
        bea.http().post(drone + "/commands?wait=30", "{\"type\":\"readHome\"}");
        ConditionWait.until(
                "what came later is told",
                () -> Optional.of(whatShows(bea)).filter(shown -> shown.contains("readHome")));
        assertThat(whatShows(bea)).doesNotContain(ann.name());
    }

    @Test
    void waitsForTheEndOfACommand() {
        kite.takesItsTime();
        String command =
                ann.http().post(drone + "/commands", "{\"type\":\"readHome\"}").text("id");
        assertThat(put(gift, "").text("detail")).contains("under way");

        Objects.requireNonNull(kite.underWay()).ended(new Outcome.Succeeded());
        ConditionWait.until(
                "it has ended",
                () -> Optional.of(ann.http().get("/api/v1/commands/" + command))
                        .filter(answer -> answer.raw().body().contains("succeeded")));
        assertThat(put(gift, "").status()).isEqualTo(200);
    }

    @Test
    void leavesNobodyWhoGaveItAwayItsKey() {
        String account = house.account(root.name());
        RobotKeyFixture.keep(
                house.robotKeys(),
                new RobotKey(
                        new DroneId(kite.id()),
                        "turtle",
                        7,
                        null,
                        "0".repeat(64),
                        root.name(),
                        account,
                        Instant.EPOCH));
        assertThat(keys(root)).contains(kite.id());

        put(gift, "");

        assertThat(keys(root)).doesNotContain(kite.id());
        assertThat(root.http()
                        .post("/api/v1/robot-keys", "{\"drone\":\"" + kite.id() + "\"}")
                        .status())
                .isEqualTo(404);
        assertThat(keys(bea)).contains(kite.id()).contains(OTHERS).doesNotContain(root.name());
    }

    @Test
    void takesNothingBackThatWasNotGiven() {
        String ours = "/api/v1/organisations/" + rescue + "/drones/" + kite.id();
        assertThat(root.http().send(ours, HttpRequest.Builder::DELETE).status()).isEqualTo(404);
        put(gift, "");
        for (OrganisationMember other : List.of(ann, bea)) {
            assertThat(other.http().send(gift, HttpRequest.Builder::DELETE).status())
                    .isEqualTo(403);
        }
    }

    /** What somebody did with the drone. */
    private record Deed(String flight, String command, String recording) {
        List<String> paths() {
            return List.of(
                    FLIGHTS + "/" + flight,
                    FLIGHTS + "/" + flight + "/events",
                    FLIGHTS + "/" + flight + "/telemetry/file?form=geojson",
                    "/api/v1/commands/" + command,
                    RECORDINGS + "/" + recording,
                    RECORDINGS + "/" + recording + "/file");
        }
    }

    private Deed fly(OrganisationMember by) {
        FrameTap wire = house.recorder().open(1);
        wire.bound(new DroneId(kite.id()));
        byte[] heartbeat = new FrameWriter(1, 1, 2).frame(new Heartbeat(2, 3, 0x81, 4, 4, 3));
        new FrameReader().read(ByteBuffer.wrap(heartbeat), wire::received);
        assertThat(by.http().post(drone + "/control/take", "").status()).isEqualTo(200);
        String command = by.http()
                .post(drone + "/commands?wait=30", "{\"type\":\"arm\"}")
                .text("id");
        kite.says(new DroneEvent.ModeReported("GUIDED", true));
        String flight = ConditionWait.until("the flight is known", () -> newest(by, FLIGHTS, "flights", "running"));
        kite.says(new DroneEvent.ModeReported("GUIDED", false));
        String ended = ConditionWait.until("the flight has ended", () -> newest(by, FLIGHTS, "flights", "ended"));
        assertThat(ended).isEqualTo(flight);
        ConditionWait.until(
                "the command is told",
                () -> Optional.of(by.http()
                                .get(FLIGHTS + "/" + flight + "/events")
                                .raw()
                                .body())
                        .filter(events -> events.contains(command)));
        assertThat(patch(by, FLIGHTS + "/" + flight, "{\"notes\":\"secret of " + by.name() + "\"}")
                        .status())
                .isEqualTo(200);
        by.http().send(drone + "/control", HttpRequest.Builder::DELETE);
        String recording = ConditionWait.until("it is recorded", () -> newest(by, RECORDINGS, "recordings", null));
        return new Deed(flight, command, recording);
    }

    private Optional<String> newest(OrganisationMember by, String path, String list, String state) {
        JsonNode newest =
                by.http().get(path + "?drone=" + kite.id()).json().path(list).path(0);
        return Optional.of(newest)
                .filter(one -> !one.isMissingNode()
                        && (state == null || one.path("state").asString().equals(state)))
                .map(one -> one.path("id").asString());
    }

    /** All that is shown of the drone without the id of something. */
    private String whatShows(OrganisationMember to) {
        StringBuilder all = new StringBuilder();
        for (String path : List.of(
                drone,
                drone + "/commands",
                drone + "/events",
                drone + "/control",
                FLIGHTS + "?drone=" + kite.id(),
                FLIGHTS + "/logbook?drone=" + kite.id(),
                RECORDINGS + "?drone=" + kite.id())) {
            all.append(to.http().get(path).raw().body());
        }
        return all.toString();
    }

    private List<String> found(OrganisationMember by, String search) {
        return by.http()
                .get(FLIGHTS + "?drone=" + kite.id() + search)
                .json()
                .path("flights")
                .valueStream()
                .map(flight -> flight.path("id").asString())
                .toList();
    }

    private static String keys(OrganisationMember of) {
        return of.http().get("/api/v1/robot-keys").raw().body();
    }

    private TestHttpClient.Answer put(String path, String body) {
        return root.http()
                .send(
                        path,
                        request -> request.header("Content-Type", "application/json")
                                .PUT(HttpRequest.BodyPublishers.ofString(body)));
    }

    private static TestHttpClient.Answer patch(OrganisationMember by, String path, String body) {
        return by.http()
                .send(
                        path,
                        request -> request.header("Content-Type", "application/json")
                                .method("PATCH", HttpRequest.BodyPublishers.ofString(body)));
    }
}
