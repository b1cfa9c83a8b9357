package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.util.Map;
import java.util.Optional;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.Command;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.ws.testserver.ConditionWait;
import org.dronemap.ws.testserver.ExposedOperations;
import org.dronemap.ws.testserver.ImmediateCopter;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** A drone is sent to a place by each face, and others see of it what they may. */
class DispatchesTest {
    private static final String PATH = "/api/v1/dispatches";
    private static final String HERE = "{\"latitude\":47.3977,\"longitude\":8.5456,\"height\":20}";

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestHttpClient operator = tenant.http(Role.OPERATOR);
    private final TestHttpClient supervisor = tenant.http(Role.SUPERVISOR);

    private ImmediateCopter lent() {
        ImmediateCopter copter = tenant.copter(tenant.unique("Copter"), new Geodetic(47.3977, 8.5456))
                .wellHeard(tenant.server().cloud());
        TestHttpClient.Answer put = supervisor.send(
                "/api/v1/warehouse/" + copter.id(),
                request -> request.header("Content-Type", "application/json")
                        .PUT(HttpRequest.BodyPublishers.ofString("{}")));
        assertThat(put.status()).isLessThan(300);
        return copter;
    }

    private TestHttpClient.Answer awaits(String id, String state) {
        return ConditionWait.until(
                "it is " + state,
                () -> Optional.of(operator.get(PATH + "/" + id))
                        .filter(answer -> answer.text("state").equals(state)));
    }

    @Test
    void theAskerGetsTheDroneInHandAndEverybodyWhoSeesItIsToldOnTheStream() {
        ImmediateCopter copter = lent();
        try (RecordingStreamClient watcher = RecordingStreamClient.withKey(tenant.server(), tenant.key(Role.VIEWER))) {
            TestHttpClient.Answer sent = operator.post(PATH, HERE);
            assertThat(sent.status()).as(sent.raw().body()).isEqualTo(201);
            assertThat(sent.text("drone")).isEqualTo(copter.id());
            assertThat(sent.text("state")).isEqualTo("chosen");
            assertThat(sent.raw().headers().firstValue("Location")).hasValue(PATH + "/" + sent.text("id"));

            TestHttpClient.Answer here = awaits(sent.text("id"), "here");
            assertThat(copter.performed()).anyMatch(Command.TakeOff.class::isInstance);
            assertThat(here.text("droneName")).startsWith("Copter");
            TestHttpClient.Answer control = operator.get("/api/v1/drones/" + copter.id() + "/control");
            assertThat(control.json().path("holder").asString()).isEqualTo(sent.text("owner"));
            assertThat(control.json().path("explicit").asBoolean()).isTrue();
            watcher.await(message -> message.path("type").asString().equals("dispatch")
                    && message.path("dispatch").path("state").asString().equals("here"));
            assertThat(operator.get(PATH).json().path("dispatches").size()).isEqualTo(1);

            TestHttpClient.Answer back = operator.post(PATH + "/" + sent.text("id") + "/cancel", "");
            assertThat(back.status()).as(back.raw().body()).isEqualTo(200);
            assertThat(back.text("state")).isEqualTo("returning");
            assertThat(operator.post(PATH + "/" + sent.text("id") + "/cancel", "")
                            .text("code"))
                    .isEqualTo("dispatch-returning");
            ConditionWait.until(
                    "it is told to fly home",
                    () -> copter.performed().stream()
                            .filter(Command.ReturnToLaunch.class::isInstance)
                            .findFirst());
        }
    }

    @Test
    void whoCannotBeSentADroneReadsWhy() {
        assertThat(operator.post(PATH, HERE).text("detail")).isEqualTo("The pool has no drone that you may command.");
        ImmediateCopter copter = lent();
        copter.hasLeft(22);
        TestHttpClient.Answer none = ConditionWait.until(
                "its battery is known",
                () -> Optional.of(operator.post(PATH, HERE))
                        .filter(answer -> answer.text("detail").contains("battery")));
        assertThat(none.status()).isEqualTo(409);
        assertThat(none.text("code")).isEqualTo("no-drone-to-send");
        assertThat(none.text("detail")).startsWith("No drone can come now. Copter");
        assertThat(operator.post(PATH, "{\"latitude\":47,\"longitude\":8,\"height\":500}")
                        .text("detail"))
                .contains("height", "5 to 120");
        assertThat(operator.post(PATH, "{\"latitude\":47}").text("detail")).contains("longitude");
        assertThat(tenant.http(Role.PLANNER).post(PATH, HERE).status()).isEqualTo(403);
        assertThat(operator.get(PATH + "/dnosuch").status()).isEqualTo(404);
    }

    @Test
    void soapSendsOneAsWell() {
        ImmediateCopter copter = lent();
        ExposedOperations faces = new ExposedOperations(tenant.server());
        String answer =
                faces.soap(operator, "sendDrone", Map.of("latitude", "47.3977", "longitude", "8.5456", "height", "20"));
        assertThat(answer).contains("sendDroneResponse", copter.id());
    }
}
