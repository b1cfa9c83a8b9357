package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.Optional;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.SetReturnHeight;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.ws.testserver.ConditionWait;
import org.dronemap.ws.testserver.ExposedOperations;
import org.dronemap.ws.testserver.ImmediateCopter;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Drones come home together by each face, and others see of it what they may. */
class RecoveriesTest {
    private static final String PATH = "/api/v1/recoveries";
    private static final String ALL = "{\"manner\":\"return\"}";

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestHttpClient operator = tenant.http(Role.OPERATOR);

    private ImmediateCopter aloft(double longitude) {
        ImmediateCopter copter = tenant.copter(tenant.unique("Copter"), new Geodetic(47.3977, longitude));
        copter.isAloft(tenant.server().cloud());
        return copter;
    }

    @Test
    void aPreviewShowsWhereEachComesDownAndCommandsNothing() {
        ImmediateCopter copter = aloft(8.5456);
        TestHttpClient.Answer preview = operator.post(PATH + "/preview", ALL);
        assertThat(preview.status()).as(preview.raw().body()).isEqualTo(200);
        assertThat(preview.json().path("drones").size()).isEqualTo(1);
        assertThat(preview.json().at("/drones/0/drone").asString()).isEqualTo(copter.id());
        assertThat(preview.json().at("/drones/0/plan/latitude").asDouble()).isEqualTo(47.3977);
        assertThat(preview.json().at("/drones/0/plan/height").asDouble()).isGreaterThan(0);
        assertThat(preview.json().path("leftOut").size()).isZero();
        assertThat(copter.performed()).isEmpty();
        assertThat(operator.get(PATH).json().path("recoveries").size()).isZero();
    }

    @Test
    void theDroneStopsTakesItsHeightAndIsSentHomeAndTheStreamTellsIt() {
        ImmediateCopter copter = aloft(8.5456);
        try (RecordingStreamClient watcher = RecordingStreamClient.withKey(tenant.server(), tenant.key(Role.VIEWER))) {
            TestHttpClient.Answer begun = operator.post(PATH, ALL);
            assertThat(begun.status()).as(begun.raw().body()).isEqualTo(201);
            assertThat(begun.text("state")).isEqualTo("stopping");
            assertThat(begun.raw().headers().firstValue("Location")).hasValue(PATH + "/" + begun.text("id"));
            watcher.await(message -> message.path("type").asString().equals("recovery")
                    && message.path("recovery").path("state").asString().equals("comingDown"));
            ConditionWait.until(
                    "it is sent home",
                    () -> copter.performed().stream()
                            .filter(Command.ReturnToLaunch.class::isInstance)
                            .findFirst());
            assertThat(copter.performed())
                    .anyMatch(Command.Hold.class::isInstance)
                    .anyMatch(SetReturnHeight.class::isInstance);
            assertThat(operator.get("/api/v1/drones/" + copter.id() + "/control")
                            .json()
                            .path("holder")
                            .asString())
                    .startsWith("The recovery");

            TestHttpClient.Answer off = operator.post(PATH + "/" + begun.text("id") + "/cancel", "");
            assertThat(off.text("state")).isEqualTo("givingBack");
            // It is on its way down already, and comes down.
            copter.isOnGround();
            ConditionWait.until(
                    "it is over",
                    () -> Optional.of(operator.get(PATH + "/" + begun.text("id")))
                            .filter(answer -> answer.text("state").equals("over")
                                    && answer.json()
                                            .at("/drones/0/outcome")
                                            .asString()
                                            .equals("down")));
        }
    }

    @Test
    void whoCannotBringAnyDroneHomeReadsWhy() {
        TestHttpClient.Answer none = operator.post(PATH, ALL);
        assertThat(none.status()).isEqualTo(409);
        assertThat(none.text("code")).isEqualTo("no-drone-to-recover");
        ImmediateCopter one = aloft(8.5456);
        ImmediateCopter other = aloft(8.545601);
        TestHttpClient.Answer near = operator.post(PATH, ALL);
        assertThat(near.text("code")).isEqualTo("recovery-does-not-fit");
        assertThat(near.text("detail")).contains("would come down 0.1 m from each other");
        assertThat(operator.post(PATH, "{}").text("detail")).contains("manner", "return or land");
        assertThat(operator.post(PATH, "{\"manner\":\"fall\"}").text("detail")).contains("return or land");
        assertThat(operator.post(PATH, "{\"manner\":\"land\",\"ceiling\":900}").text("detail"))
                .contains("ceiling", "5 to 500");
        assertThat(operator.post(PATH, "{\"manner\":\"return\",\"ceiling\":30,\"lowest\":60}")
                        .text("detail"))
                .contains("ceiling");
        assertThat(operator.post(PATH, "{\"manner\":\"return\",\"drones\":[\"nosuch\"]}")
                        .text("detail"))
                .contains("There is no drone of this id");
        assertThat(tenant.http(Role.PLANNER).post(PATH, ALL).status()).isEqualTo(403);
        assertThat(operator.get(PATH + "/cnosuch").status()).isEqualTo(404);
        assertThat(one.performed()).isEmpty();
        assertThat(other.performed()).isEmpty();
    }

    @Test
    void whatWasPreviewedIsBegunAndNothingElse() {
        ImmediateCopter first = aloft(8.5456);
        String alone = "{\"manner\":\"return\",\"previewed\":[\"" + first.id() + "\"]}";
        ImmediateCopter second = aloft(8.5459);
        String name = operator.get("/api/v1/drones/" + second.id()).text("name");
        TestHttpClient.Answer more = operator.post(PATH, alone);
        assertThat(more.status()).isEqualTo(409);
        assertThat(more.text("code")).isEqualTo("recovery-changed");
        assertThat(more.text("detail"))
                .isEqualTo("Since the preview more drones would come: " + name + ". Look at a new preview.");
        assertThat(operator.post(PATH + "/preview", alone).json().path("drones").size())
                .isEqualTo(2);

        second.isOnGround();
        ConditionWait.until(
                "it is down",
                () -> tenant.server().cloud().drone(new DroneId(second.id())).filter(drone -> !drone.airborne()));
        String both = "{\"manner\":\"return\",\"previewed\":[\"" + first.id() + "\",\"" + second.id() + "\"]}";
        assertThat(operator.post(PATH, both).text("detail"))
                .isEqualTo("Since the preview fewer drones would come. " + name
                        + " is not in the air. Look at a new preview.");
        assertThat(operator.post(PATH, "{\"manner\":\"return\",\"previewed\":[\"" + first.id() + "\",\"x y\"]}")
                        .text("detail"))
                .contains("x y is not in the air.");
        ExposedOperations faces = new ExposedOperations(tenant.server());
        assertThat(first.performed()).isEmpty();
        assertThat(faces.soap(
                        operator,
                        "beginRecovery",
                        Map.of(
                                "manner",
                                "return",
                                "previewed",
                                "<item>" + first.id() + "</item><item>" + second.id() + "</item>")))
                .contains("recovery-changed");
        assertThat(operator.post(PATH, alone).status()).isEqualTo(201);
    }

    @Test
    void whoIsLeftOutIsNamedWithACodeForPrograms() {
        ImmediateCopter comes = aloft(8.5456);
        ImmediateCopter held = aloft(8.5459);
        ImmediateCopter stands = tenant.copter(tenant.unique("Copter"), new Geodetic(47.3977, 8.5462));
        tenant.http(Role.OPERATOR).post("/api/v1/drones/" + held.id() + "/control/take", "");
        TestHttpClient.Answer preview = operator.post(
                PATH + "/preview",
                "{\"manner\":\"return\",\"drones\":[\"nosuch\",\"" + comes.id() + "\",\"" + held.id() + "\",\""
                        + stands.id() + "\"]}");
        assertThat(preview.json().path("leftOut").findValuesAsString("code"))
                .containsExactly("drone-unknown", "control-held", "not-airborne");
        assertThat(preview.json().path("leftOut").findValuesAsString("why")).hasSize(3);
    }

    @Test
    void soapBeginsOneAsWell() {
        ImmediateCopter copter = aloft(8.5456);
        ExposedOperations faces = new ExposedOperations(tenant.server());
        String answer = faces.soap(operator, "beginRecovery", Map.of("manner", "return"));
        assertThat(answer).contains("beginRecoveryResponse", copter.id());
    }
}
