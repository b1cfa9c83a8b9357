package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.net.http.HttpRequest;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.SendAuthority;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.record.TextMessageTap;
import org.dronemap.proxy.session.FrameTap;
import org.dronemap.ws.testserver.ConditionWait;
import org.dronemap.ws.testserver.SharedServer;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;

/** Recordings over REST: listed, downloaded, played and deleted by those who may. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class ReplayGatewayTest {
    private static final String PATH = "/api/v1/recordings";

    private TestServer house;
    private TestHttpClient viewer;
    private TestHttpClient operator;

    @BeforeAll
    void open() {
        house = SharedServer.get();
        viewer = new TestHttpClient(house, house.key(Role.VIEWER));
        operator = new TestHttpClient(house, house.key(Role.OPERATOR));
    }

    @Test
    void nobodySeesThemWithoutSigningIn() {
        assertThat(new TestHttpClient(house, "").get(PATH).status()).isEqualTo(401);
    }

    @Test
    void aViewerListsAndDownloadsAFlightThatGoesOn() {
        FrameTap tap = fly("viewed");
        String id = idOf("viewed");
        TestHttpClient.Answer one = viewer.get(PATH + "/" + id);
        assertThat(one.text("state")).isEqualTo("running");
        assertThat(one.json().path("end").isNull()).isTrue();
        TestHttpClient.Answer file = viewer.get(PATH + "/" + id + "/file");
        assertThat(file.status()).isEqualTo(200);
        assertThat(file.raw().headers().firstValue("Content-Length")).contains("" + (8 + 21));
        assertThat(file.raw().headers().firstValue("Content-Disposition"))
                .hasValueSatisfying(value -> assertThat(value).endsWith(".tlog\""));
        assertThat(viewer.get(PATH + "?drone=another").json().path("recordings").size())
                .isZero();
        assertThat(viewer.get(PATH).json().path("room").path("mostBytes").asLong())
                .isEqualTo(2_000_000_000L);
        tap.ended();
    }

    @Test
    void saysThatAFileIsGone() throws IOException {
        FrameTap tap = fly("gone");
        String id = idOf("gone");
        tap.ended();
        ConditionWait.until(
                "the recording has ended",
                () -> Optional.of(viewer.get(PATH + "/" + id).json().path("end"))
                        .filter(end -> !end.isNull()));
        try (Stream<Path> files = Files.walk(house.data().resolve("recordings"))) {
            for (Path file : files.filter(path -> path.toString().contains(id)).toList()) {
                Files.delete(file);
            }
        }

        TestHttpClient.Answer file = viewer.get(PATH + "/" + id + "/file");
        assertThat(file.status()).isEqualTo(409);
        assertThat(file.text("code")).isEqualTo("recording-file-gone");
    }

    @Test
    void onlyAnOperatorDeletesAndOnlyWhenSure() {
        FrameTap tap = fly("deleted");
        String path = PATH + "/" + idOf("deleted");
        assertThat(delete(viewer, path + "?confirm=true").status()).isEqualTo(403);
        TestHttpClient.Answer unsure = delete(operator, path);
        assertThat(unsure.status()).isEqualTo(422);
        assertThat(unsure.text("field")).isEqualTo("confirm");
        TestHttpClient.Answer early = delete(operator, path + "?confirm=true");
        assertThat(early.status()).isEqualTo(409);
        assertThat(early.text("detail")).contains("goes on");
        tap.ended();
        TestHttpClient.Answer ended = ConditionWait.until(
                "the recording has ended",
                () -> Optional.of(viewer.get(path))
                        .filter(now -> now.text("state").equals("incomplete")));
        assertThat(ended.text("notice")).contains("Contact was lost");
        assertThat(delete(operator, path + "?confirm=true").status()).isEqualTo(204);
        assertThat(viewer.get(path).status()).isEqualTo(404);
        assertThat(viewer.get(path + "/file").status()).isEqualTo(404);
    }

    @Test
    void anOperatorPlaysOne() {
        FrameTap tap = fly("played");
        String path = PATH + "/" + idOf("played") + "/replays";
        assertThat(viewer.post(path, "").status()).isEqualTo(403);
        assertThat(operator.post(path + "?speed=1000", "").text("field")).isEqualTo("speed");
        TestHttpClient.Answer replay = operator.post(path + "?speed=10", "");
        assertThat(replay.status()).isEqualTo(202);
        // The house of the tests plays nothing and counts the bytes.
        assertThat(replay.json().path("records").asInt()).isEqualTo(8 + 21);
        tap.ended();
    }

    @Test
    void aDriveIsDownloadedInLinesByItsOwnersAloneAndNotPlayed() {
        TextMessageTap tap = house.recorder().openLines();
        tap.bound(new DroneId("rover"));
        tap.received("{\"vx\":0}", 8);
        tap.working(true);
        tap.sent("{\"vx\":0.4}", 10, SendAuthority.HOUSEKEEPING);
        String path = PATH + "/" + idOf("rover");
        TestHttpClient.Answer file = viewer.get(path + "/file");
        assertThat(file.raw().headers().firstValue("Content-Disposition"))
                .hasValueSatisfying(value -> assertThat(value).endsWith(".jsonl\""));
        assertThat(file.raw().headers().firstValue("Content-Type"))
                .hasValueSatisfying(value -> assertThat(value).startsWith("application/jsonl"));
        assertThat(file.raw().body().lines())
                .hasSize(2)
                .first()
                .satisfies(line -> assertThat(line).endsWith("\"up\":true,\"text\":\"{\\\"vx\\\":0}\"}"));
        assertThat(viewer.get(path + "/sent").raw().body().lines()).hasSize(2);
        TestHttpClient.Answer replay = operator.post(path + "/replays", "");
        assertThat(replay.status()).isEqualTo(409);
        assertThat(replay.text("detail")).contains("cannot be played");
        TestHttpClient stranger = house.member(
                        new OrganisationId("others"), "stranger-" + house.number(), Role.ADMINISTRATOR)
                .http();
        assertThat(stranger.get(path).status()).isEqualTo(404);
        assertThat(stranger.get(path + "/file").status()).isEqualTo(404);
        assertThat(stranger.get(PATH).json().path("recordings").size()).isZero();
        tap.ended();
    }

    @Test
    void pathsLeadNowhereElse() throws IOException {
        for (String id : new String[] {"..%2Flocal-key", "nothing", "%2e%2e"}) {
            assertThat(operator.get(PATH + "/" + id + "/file").status()).isBetween(400, 404);
        }
        try (InputStream key = Files.newInputStream(house.data().resolve("local-key"))) {
            assertThat(key.read()).isPositive();
        }
    }

    private static TestHttpClient.Answer delete(TestHttpClient who, String path) {
        return who.send(path, HttpRequest.Builder::DELETE);
    }

    /** A vehicle that says once that it is armed. */
    private FrameTap fly(String drone) {
        FrameTap tap = house.recorder().open(1);
        tap.bound(new DroneId(drone));
        byte[] heartbeat = new FrameWriter(1, 1, 2).frame(new Heartbeat(2, 3, 0x81, 4, 4, 3));
        new FrameReader().read(ByteBuffer.wrap(heartbeat), tap::received);
        return tap;
    }

    private String idOf(String drone) {
        return ConditionWait.until(
                "the recording of " + drone + " is listed",
                () -> Optional.of(viewer.get(PATH + "?drone=" + drone)
                                .json()
                                .path("recordings")
                                .path(0)
                                .path("id")
                                .asString(""))
                        .filter(id -> !id.isEmpty()));
    }
}
