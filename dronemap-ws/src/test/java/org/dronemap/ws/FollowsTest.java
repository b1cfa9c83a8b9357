package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.lease.Lease;
import org.dronemap.core.operation.JournalEntry;
import org.dronemap.core.operation.JournalReplay;
import org.dronemap.core.operation.OperationId;
import org.dronemap.ws.testserver.ConditionWait;
import org.dronemap.ws.testserver.ImmediateCopter;
import org.dronemap.ws.testserver.OrganisationMember;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;

/** A phone asks to be followed, by REST. */
class FollowsTest {
    private static final String PATH = "/api/v1/follows";
    private static final Geodetic HOME = new Geodetic(47.3977, 8.5456);
    private static final Geodetic PHONE = new Geodetic(47.3980, 8.5456);
    private static final String HERE = "\"latitude\":47.3980,\"longitude\":8.5456";

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestServer house = tenant.server();
    private final List<String> waiting = new ArrayList<>();
    private List<String> keys;
    private TestHttpClient phone;
    private TestHttpClient supervisor;
    private ImmediateCopter falcon;
    private String name;

    @BeforeEach
    void begin() {
        keys = List.of(tenant.key(Role.OPERATOR), tenant.key(Role.SUPERVISOR));
        phone = new TestHttpClient(house, keys.get(0));
        supervisor = new TestHttpClient(house, keys.get(1));
        name = "Falcon " + house.number();
        falcon = copter(name, HOME);
    }

    /** What another test chooses is its own. */
    @AfterEach
    void end() {
        waiting.forEach(id -> supervisor.send("/api/v1/warehouse/" + id, HttpRequest.Builder::DELETE));
    }

    private ImmediateCopter copter(String name, Geodetic stand) {
        ImmediateCopter copter = tenant.copter(name, stand).wellHeard(house.cloud());
        waiting.add(copter.id());
        assertThat(served(supervisor, copter).status()).isLessThan(300);
        return copter;
    }

    private static TestHttpClient.Answer served(TestHttpClient by, ImmediateCopter copter) {
        return by.send(
                "/api/v1/warehouse/" + copter.id(),
                request -> request.header("Content-Type", "application/json")
                        .PUT(HttpRequest.BodyPublishers.ofString("{}")));
    }

    private String asked(String members) {
        TestHttpClient.Answer asked = phone.post(PATH, "{" + HERE + members + "}");
        assertThat(asked.status()).as(asked.raw().body()).isEqualTo(201);
        assertThat(asked.text("state")).isEqualTo("allocated");
        return PATH + "/" + asked.text("id");
    }

    private String following() {
        String follow = asked("");
        assertThat(phone.post(follow + "/start", "").text("state")).isEqualTo("starting");
        await(follow, "tracking");
        return follow;
    }

    private TestHttpClient.Answer await(String follow, String state) {
        return ConditionWait.until(
                "the follow is " + state,
                () -> Optional.of(phone.get(follow))
                        .filter(one -> one.text("state").equals(state)));
    }

    private TestHttpClient.Answer says(TestHttpClient who, String follow) {
        Instant now = Instant.now();
        return who.post(
                follow + "/positions",
                "{\"sent\":\"" + now + "\",\"roundTrip\":40,\"positions\":[{\"at\":\"" + now + "\"," + HERE
                        + ",\"accuracy\":5}]}");
    }

    private boolean isHeldByAFollow() {
        Lease tenure =
                house.cloud().controls().control(new DroneId(falcon.id())).tenure();
        return tenure != null && tenure.holder().words().startsWith("The follow");
    }

    private static String detail(TestHttpClient.Answer answer) {
        return answer.status() + " " + answer.text("field") + " " + answer.text("detail");
    }

    private TestHttpClient.Answer patch(String path, String body) {
        return phone.send(
                path,
                request -> request.header("Content-Type", "application/json")
                        .method("PATCH", HttpRequest.BodyPublishers.ofString(body)));
    }

    @Test
    void leadsTheNearestDroneToThePhoneAndHome() {
        copter("Heron", new Geodetic(47.4040, 8.5456));
        String follow = asked(",\"place\":{\"side\":\"fixed\",\"bearing\":180,\"distance\":10,\"height\":20}");
        assertThat(phone.get(follow).text("drone")).isEqualTo(falcon.id());
        assertThat(phone.get(follow).json().path("told").path(0).path("words").asString())
                .startsWith(name + " was chosen:");
        assertThat(isHeldByAFollow()).isTrue();

        phone.post(follow + "/start", "");
        await(follow, "tracking");
        assertThat(falcon.performed()).hasSize(4).last().isEqualTo(new Command.TakeOff(20));
        assertThat(says(phone, follow).status()).isEqualTo(200);
        Setpoint.Track track = ConditionWait.until(
                "it is led north",
                () -> falcon.setpoints().stream()
                        .filter(Setpoint.Track.class::isInstance)
                        .map(Setpoint.Track.class::cast)
                        .filter(one -> one.moving() != null && one.moving().forward() > 0.3)
                        .findFirst());
        assertThat(Geodesy.distanceMeters(track.point(), PHONE)).isLessThan(Geodesy.distanceMeters(HOME, PHONE));
        assertThat(track.altitude().meters()).isBetween(500.0, 508.1);

        phone.post(follow + "/stop", "");
        ConditionWait.until(
                "it is called home",
                () -> falcon.performed().stream()
                        .filter(Command.ReturnToLaunch.class::isInstance)
                        .findFirst());
        falcon.isOnGround();
        assertThat(await(follow, "over").text("end")).contains(name + " is down");
        assertThat(isHeldByAFollow()).isFalse();
        decidesTheSameAgain(follow);
    }

    @Test
    void hearsThePhoneAndTellsOfTheDroneOnTheStream() {
        String follow = following();
        String id = follow.substring(PATH.length() + 1);
        String phoneKey = keys.get(0);
        try (RecordingStreamClient mine = RecordingStreamClient.withKey(house, phoneKey);
                RecordingStreamClient others = RecordingStreamClient.withKey(house, keys.get(1))) {
            JsonNode all = mine.await(message -> isType(message, "follow"));
            assertThat(all.path("follow").path("state").asString()).isEqualTo("tracking");
            assertThat(all.path("follow").path("patience").asInt()).isEqualTo(60);
            Instant now = Instant.now();
            mine.send(positions(id, "r1", now, position(1, now.minusSeconds(2)), position(2, now.minusSeconds(1))));
            assertThat(receipt(mine, "r1")).isEqualTo(id + " up to 2, 2 taken, 0 known");
            // What was sent twice, as after a gap, counts once.
            mine.send(positions(id, "r2", now, position(3, now), position(2, now.minusSeconds(1))));
            assertThat(receipt(mine, "r2")).isEqualTo(id + " up to 3, 1 taken, 1 known");
            mine.send(positions(id, "r3", now));
            assertThat(receipt(mine, "r3")).isEqualTo(id + " up to , 0 taken, 0 known");
            others.send(positions(id, "r4", now, position(9, now)));
            assertThat(others.await(message -> isAnswer(message, "r4"))
                            .path("problem")
                            .path("status")
                            .asInt())
                    .isEqualTo(403);

            tellsHowTheDroneComes(others, id);
            phone.post(follow + "/pause", "");
            mine.await(message -> isType(message, "follow")
                    && message.path("follow").path("state").asString().equals("paused"));
        }
        assertThat(phone.get(follow).json().path("now").path("phone").path("id").asInt())
                .isEqualTo(3);
        ConditionWait.until(
                "the phone is gone",
                () -> Optional.of(phone.get(follow)
                                .json()
                                .path("now")
                                .path("reach")
                                .asString(""))
                        .filter("gone"::equals));
    }

    private void tellsHowTheDroneComes(RecordingStreamClient others, String id) {
        falcon.hasLeft(80);
        JsonNode live = others.await(message -> isType(message, "followNow")
                && message.path("now").path("battery").asInt() == 80
                && message.path("now").path("phone").path("id").asInt() == 3);
        assertThat(live.path("id").asString()).isEqualTo(id);
        assertThat(live.path("now").path("distance").asDouble()).isBetween(30.0, 36.0);
        assertThat(live.path("now").path("height").asDouble()).isEqualTo(20);
        assertThat(live.path("now").path("secondsLeft").asInt()).isBetween(700, 720);
    }

    private static String position(int number, Instant at) {
        return "{\"id\":" + number + ",\"at\":\"" + at + "\"," + HERE + ",\"accuracy\":4}";
    }

    @Test
    void aKeyWithAnAreaLeadsNoDroneAway() {
        String follow = asked("");
        String area = "\"area\":{\"type\":\"Point\",\"coordinates\":[8.5456,47.3977],\"radius\":100}";

        assertThat(detail(says(limited(phone, area), follow))).startsWith("403").contains("area or heights");
        assertThat(says(limited(phone, "\"operations\":[\"view\"]"), follow).status())
                .isEqualTo(403);
        assertThat(served(limited(supervisor, area), falcon).status()).isEqualTo(403);
    }

    private TestHttpClient limited(TestHttpClient owner, String limits) {
        TestHttpClient.Answer made = owner.post("/api/v1/access-keys", "{\"label\":\"x\"," + limits + "}");
        return new TestHttpClient(house, made.text("key"));
    }

    private static String positions(String follow, String request, Instant sent, String... positions) {
        return "{\"type\":\"positions\",\"requestId\":\"" + request + "\",\"follow\":\"" + follow + "\",\"sent\":\""
                + sent + "\",\"positions\":[" + String.join(",", positions) + "]}";
    }

    private static String receipt(RecordingStreamClient stream, String request) {
        JsonNode answer = stream.await(message -> isAnswer(message, request));
        JsonNode receipt = answer.path("receipt");
        return receipt.path("follow").asString("") + " up to "
                + receipt.path("upTo").asString("") + ", "
                + receipt.path("taken").asInt() + " taken, "
                + receipt.path("known").asInt() + " known";
    }

    private static boolean isType(JsonNode message, String type) {
        return message.path("type").asString().equals(type);
    }

    private static boolean isAnswer(JsonNode message, String request) {
        return message.path("requestId").asString("").equals(request);
    }

    @Test
    void leavesControlWithWhoAsksAFollowThatIsOverToGoOn() {
        String follow = asked("");
        phone.post(follow + "/cancel", "");
        await(follow, "over");
        assertThat(phone.post("/api/v1/drones/" + falcon.id() + "/control/take", "{}")
                        .status())
                .isEqualTo(200);

        assertThat(phone.post(follow + "/continue", "").status()).isEqualTo(409);

        assertThat(house.cloud().controls().control(new DroneId(falcon.id())).tenure())
                .isNotNull();
    }

    private void decidesTheSameAgain(String follow) {
        List<JournalEntry> journal =
                house.runs().operations().journal(new OperationId(follow.substring(PATH.length() + 1)), 0, 200);
        JournalReplay<?, ?> replay = new JournalReplay<>(house.runs().follows());
        replay.replay(journal);
        assertThat(replay.difference()).isEmpty();
        // Neither positions nor setpoints are decisions.
        assertThat(journal.size()).isBetween(8, 20);
    }

    @Test
    void waitsInThePauseAndGoesOn() {
        String follow = following();
        says(phone, follow);
        ConditionWait.until(
                "it is led",
                () -> falcon.setpoints().stream()
                        .filter(Setpoint.Track.class::isInstance)
                        .findFirst());
        assertThat(phone.post(follow + "/pause", "").text("state")).isEqualTo("paused");
        ConditionWait.until(
                "it is told to stand still",
                () -> falcon.setpoints().stream()
                        .filter(Setpoint.Velocity.class::isInstance)
                        .findFirst());
        phone.post(follow + "/continue", "");
        await(follow, "tracking");
        assertThat(patch(follow, "{\"distance\":30}")
                        .json()
                        .path("place")
                        .path("distance")
                        .asDouble())
                .isEqualTo(30);
    }

    @Test
    void isLeftAloneByWhoeverIsTaken() {
        String follow = following();
        String control = "/api/v1/drones/" + falcon.id() + "/control";
        supervisor.post(control + "/take-over", "{\"reason\":\"a look\"}");
        await(follow, "suspended");
        assertThat(detail(phone.post(follow + "/pause", ""))).startsWith("409 ").contains("Somebody else has");
        supervisor.send(control, HttpRequest.Builder::DELETE);
        phone.post(follow + "/continue", "");
        await(follow, "tracking");
        assertThat(isHeldByAFollow()).isTrue();
    }

    @Test
    void saysWhyNoDroneCanFollow() {
        falcon.hasLeft(30);
        ConditionWait.until(
                "the battery is known",
                () -> house.cloud()
                        .drone(new DroneId(falcon.id()))
                        .filter(state -> state.battery() != null
                                && Integer.valueOf(30).equals(state.battery().percent())));
        assertThat(detail(phone.post(PATH, "{" + HERE + "}")))
                .startsWith("409 ")
                .contains("No drone can follow now.", name + ": Its battery has 30 %");
        assertThat(isHeldByAFollow()).isFalse();
    }

    @Test
    void reckonsWithTheWindThatItsUserMayKnowAlone() {
        ImmediateCopter hidden = copter("Kestrel " + house.number(), HOME);
        hidden.feelsWind(270, 6);
        ConditionWait.until(
                "the wind is known",
                () -> house.cloud()
                        .drone(new DroneId(hidden.id()))
                        .filter(state -> state.payload().wind() != null));
        String wind = "a wind of 6 m/s from 270°";
        String chosen = ",\"drone\":\"" + falcon.id() + "\"";
        String follow = asked(chosen);
        assertThat(phone.get(follow).raw().body()).contains(wind);
        assertThat(phone.post(follow + "/cancel", "").status()).isLessThan(300);

        OrganisationMember guest = tenant.member("guest", Role.OPERATOR);
        TestHttpClient root = tenant.http(Role.ADMINISTRATOR);
        TestHttpClient.Answer only = root.send(
                "/api/v1/users/" + guest.name() + "/only-granted",
                request -> request.header("Content-Type", "application/json")
                        .PUT(HttpRequest.BodyPublishers.ofString("{\"onlyGranted\":true}")));
        assertThat(only.status()).isEqualTo(204);
        TestHttpClient.Answer granted = root.post(
                "/api/v1/grants",
                "{\"user\":\"" + guest.name() + "\",\"drones\":[\"" + falcon.id()
                        + "\"],\"operations\":[\"view\",\"plan\",\"command\"]}");
        assertThat(granted.status()).as(granted.raw().body()).isEqualTo(201);
        TestHttpClient.Answer theirs = guest.http().post(PATH, "{" + HERE + chosen + "}");
        assertThat(theirs.status()).as(theirs.raw().body()).isEqualTo(201);
        assertThat(theirs.raw().body()).doesNotContain("wind");
    }

    @Test
    void choosesNoDroneThatSomebodyHasToStandBeside() {
        supervisor.send("/api/v1/warehouse/" + falcon.id(), HttpRequest.Builder::DELETE);
        assertThat(detail(phone.post(PATH, "{" + HERE + "}")))
                .startsWith("409 ")
                .contains("The warehouse has no drone that you may command");
        asked(",\"drone\":\"" + falcon.id() + "\"");
    }

    @Test
    void answersStepsThatCannotBeTakenAndMembersThatAreWrong() {
        String follow = asked("");
        assertThat(detail(phone.post(follow + "/pause", ""))).startsWith("409 ").contains("not been started");
        assertThat(phone.post(follow + "/pause", "").text("code")).isEqualTo("follow-not-started");
        assertThat(detail(phone.post(follow + "/stop", ""))).startsWith("409 ");
        assertThat(detail(phone.post(PATH, "{" + HERE + "}")))
                .startsWith("409 ")
                .contains("The follow");
        assertThat(detail(says(supervisor, follow))).startsWith("403 ").contains("says where the phone is");
        assertThat(detail(phone.post(follow + "/positions", "{}"))).startsWith("422 sent ");
        assertThat(detail(phone.post(follow + "/positions", "{\"sent\":\"" + Instant.now() + "\",\"positions\":[{}]}")))
                .startsWith("422 positions[0].at ");
        assertThat(detail(phone.post(follow + "/positions", "{\"sent\":\"yesterday\",\"positions\":[]}")))
                .startsWith("422 sent ")
                .contains("must be a time");
        assertThat(detail(patch(follow, "{\"side\":\"above\"}"))).startsWith("422 side ");
        assertThat(detail(patch(follow, "{\"side\":\"orbit\",\"turn\":0}"))).startsWith("422 turn ");
        assertThat(detail(phone.post(PATH, "{\"latitude\":47}"))).startsWith("422 longitude ");
        assertThat(detail(phone.post(PATH, "{" + HERE + ",\"drone\":\"nobody\"}")))
                .startsWith("404 ");
        assertThat(phone.post(follow + "/cancel", "").text("state")).isEqualTo("over");
        assertThat(isHeldByAFollow()).isFalse();
        assertThat(detail(phone.post(follow + "/start", ""))).isEqualTo("409  This follow is over.");
    }
}
