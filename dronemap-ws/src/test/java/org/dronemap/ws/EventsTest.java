package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.ws.testserver.OrganisationMember;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;

/** Programs that follow what happens to drones, over REST. */
class EventsTest {
    private static final String PATH = "/api/v1/events";

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final ScriptedVehicle one = tenant.vehicle();
    private final ScriptedVehicle two = tenant.vehicle();
    private final TestHttpClient viewer = tenant.http(Role.VIEWER);

    @Test
    void goesOnWhereTheAnswerBeforeEnded() {
        String start = viewer.get(PATH).text("next");

        says(one, "first");
        TestHttpClient.Answer first = awaited(viewer, start, "");
        says(two, "second");
        TestHttpClient.Answer second = awaited(viewer, first.text("next"), "");
        TestHttpClient.Answer nothing = viewer.get(PATH + "?after=" + second.text("next"));

        assertThat(texts(first)).containsExactly("first");
        assertThat(said(first).get(0).path("drone").asString()).isEqualTo(one.id());
        assertThat(texts(second)).containsExactly("second");
        assertThat(said(second).get(0).path("number").asLong())
                .isGreaterThan(said(first).get(0).path("number").asLong());
        assertThat(texts(nothing)).isEmpty();
        assertThat(nothing.json().path("gaps").size()).isZero();
    }

    @Test
    void answersAtOnceFromNowOn() {
        String start = viewer.get(PATH).text("next");
        says(one, "before");
        assertThat(texts(awaited(viewer, start, ""))).containsExactly("before");

        TestHttpClient.Answer now = viewer.get(PATH + "?wait=60");

        assertThat(now.status()).isEqualTo(200);
        assertThat(texts(now)).isEmpty();
        assertThat(now.text("next")).isNotEqualTo(start);
    }

    @Test
    void saysWhichParameterIsNoNumber() {
        TestHttpClient.Answer wrong = viewer.get(PATH + "?limit=many");

        assertThat(wrong.status()).isEqualTo(422);
        assertThat(wrong.text("code")).isEqualTo("value-malformed");
        assertThat(wrong.text("field")).isEqualTo("limit");
        assertThat(wrong.text("detail")).isEqualTo("\"limit\" must be a number, not \"many\".");
    }

    @Test
    void showsTheDronesThatAreAskedForAlone() {
        String start = viewer.get(PATH).text("next");
        says(one, "of the other");
        assertThat(texts(awaited(viewer, start, ""))).containsExactly("of the other");
        says(two, "of this one");

        TestHttpClient.Answer found = awaited(viewer, start, "&drones=nobody," + two.id());

        assertThat(texts(found)).containsExactly("of this one");
    }

    @Test
    void showsNothingOfOtherOrganisations() {
        try (TestTenant others = new TestTenant()) {
            TestHttpClient stranger = others.http(Role.ADMINISTRATOR);
            ScriptedVehicle theirs = others.vehicle();
            String start = stranger.get(PATH).text("next");
            String ours = viewer.get(PATH).text("next");
            says(one, "not theirs");
            assertThat(texts(awaited(viewer, ours, ""))).containsExactly("not theirs");
            says(theirs, "theirs");

            TestHttpClient.Answer found = awaited(stranger, start, "");

            assertThat(texts(found)).containsExactly("theirs");
        }
    }

    @Test
    void showsNothingOfAGrantThatWasTakenBackMeanwhile() throws Exception {
        OrganisationMember root = tenant.member("root", Role.ADMINISTRATOR);
        OrganisationMember ann = tenant.member("ann", Role.VIEWER);
        put(root, "/api/v1/users/" + ann.name() + "/only-granted", "{\"onlyGranted\":true}");
        String taken = grant(root, ann, one);
        grant(root, ann, two);
        String start = ann.http().get(PATH).text("next");
        CompletableFuture<TestHttpClient.Answer> waiting =
                CompletableFuture.supplyAsync(() -> awaited(ann.http(), start, ""));

        root.http().send("/api/v1/grants/" + taken, HttpRequest.Builder::DELETE);
        says(one, "hidden");
        assertThat(texts(awaited(root.http(), start, ""))).containsExactly("hidden");
        says(two, "shown");

        assertThat(texts(waiting.get(60, TimeUnit.SECONDS))).containsExactly("shown");
    }

    @Test
    void refusesWhatItCannotRead() {
        for (String wrong :
                List.of("after=yesterday", "limit=0", "limit=1001", "wait=61", "wait=-1", "drones=a%20b,c")) {
            TestHttpClient.Answer refused = viewer.get(PATH + "?" + wrong);

            assertThat(refused.status()).as(wrong).isEqualTo(422);
            assertThat(refused.text("detail")).as(wrong).startsWith("\"" + wrong.split("=", -1)[0] + "\" must be ");
        }
        assertThat(viewer.get(PATH + "?after=yesterday").text("code")).isEqualTo("value-malformed");
        assertThat(viewer.get(PATH + "?after=yesterday").text("detail"))
                .isEqualTo("\"after\" must be first, or what an answer gave as next, not \"yesterday\".");
    }

    @Test
    void tellsTheVersionOfTheServerWithEachAnswer() {
        String version = viewer.get("/api/v1/health").text("version");

        for (String path : List.of("/api/v1/health", PATH, PATH + "?wait=x", "/api/v1/nothing", "/api/v1/users")) {
            assertThat(viewer.get(path).raw().headers().firstValue("Dronemap-Version"))
                    .as(path)
                    .contains(version);
        }
        TestHttpClient nobody = new TestHttpClient(tenant.server(), "");
        assertThat(nobody.get(PATH).status()).isEqualTo(401);
        assertThat(nobody.get(PATH).raw().headers().firstValue("Dronemap-Version"))
                .contains(version);
    }

    private static void put(OrganisationMember who, String path, String body) {
        TestHttpClient.Answer done = who.http()
                .send(
                        path,
                        request -> request.header("Content-Type", "application/json")
                                .PUT(HttpRequest.BodyPublishers.ofString(body)));
        assertThat(done.status()).isBetween(200, 204);
    }

    private static String grant(OrganisationMember root, OrganisationMember to, ScriptedVehicle vehicle) {
        TestHttpClient.Answer made = root.http()
                .post(
                        "/api/v1/grants",
                        "{\"user\":\"" + to.name() + "\",\"drones\":[\"" + vehicle.id()
                                + "\"],\"operations\":[\"view\"]}");
        assertThat(made.status()).isEqualTo(201);
        return made.text("id");
    }

    /** The first answer with something that the test has a vehicle say; others tell that it has come. */
    private static TestHttpClient.Answer awaited(TestHttpClient who, String after, String more) {
        String place = after;
        for (int tries = 0; tries < 20; tries++) {
            TestHttpClient.Answer answer = who.get(PATH + "?after=" + place + "&wait=30" + more);
            assertThat(answer.status()).isEqualTo(200);
            if (!texts(answer).isEmpty()) {
                return answer;
            }
            place = answer.text("next");
        }
        throw new AssertionError("nothing was said after " + after);
    }

    private static void says(ScriptedVehicle vehicle, String text) {
        vehicle.says(new DroneEvent.TextReported(Severity.CRITICAL, text));
    }

    private static List<String> texts(TestHttpClient.Answer answer) {
        return said(answer).stream().map(event -> event.path("text").asString()).toList();
    }

    private static List<JsonNode> said(TestHttpClient.Answer answer) {
        return answer.json()
                .path("events")
                .valueStream()
                .filter(event -> event.path("severity").asString("").equals("critical"))
                .toList();
    }
}
