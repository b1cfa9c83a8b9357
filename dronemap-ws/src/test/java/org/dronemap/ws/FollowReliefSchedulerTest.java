package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.lease.Lease;
import org.dronemap.core.operation.JournalReplay;
import org.dronemap.core.operation.OperationId;
import org.dronemap.ws.testserver.ConditionWait;
import org.dronemap.ws.testserver.ExposedOperations;
import org.dronemap.ws.testserver.ImmediateCopter;
import org.dronemap.ws.testserver.OrganisationMember;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;

/** A drone that runs low is replaced by one of the warehouse, and each face shows it. */
class FollowReliefSchedulerTest {
    private static final String PATH = "/api/v1/follows";
    private static final Geodetic HOME = new Geodetic(47.3977, 8.5456);
    private static final Geodetic ASIDE = new Geodetic(47.3979, 8.5456);
    private static final Geodetic BESIDE = new Geodetic(47.3977, 8.5458);
    private static final String HERE = "\"latitude\":47.3978,\"longitude\":8.5456";

    /** What is left is too little to wait for another one. */
    private static final int LOW = 24;

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestServer house = tenant.server();
    private ExposedOperations faces;
    private OrganisationMember mia;
    private TestHttpClient supervisor;
    private ImmediateCopter falcon;

    @BeforeEach
    void open() {
        faces = new ExposedOperations(house);
        mia = tenant.member("mia", Role.OPERATOR);
        supervisor = tenant.http(Role.SUPERVISOR);
        falcon = copter("Falcon", HOME);
    }

    private ImmediateCopter copter(String name, Geodetic stand) {
        ImmediateCopter copter = tenant.copter(name, stand).wellHeard(house.cloud());
        TestHttpClient.Answer waits = supervisor.send(
                "/api/v1/warehouse/" + copter.id(),
                request -> request.header("Content-Type", "application/json")
                        .PUT(HttpRequest.BodyPublishers.ofString("{}")));
        assertThat(waits.status()).isLessThan(300);
        return copter;
    }

    private String following() {
        TestHttpClient.Answer asked = mia.http().post(PATH, "{" + HERE + ",\"drone\":\"" + falcon.id() + "\"}");
        assertThat(asked.status()).as(asked.raw().body()).isEqualTo(201);
        String follow = PATH + "/" + asked.text("id");
        mia.http().post(follow + "/start", "");
        says(follow);
        await(follow, "it follows", seen -> seen.path("state").asString().equals("tracking"));
        return follow;
    }

    private void says(String follow) {
        Instant now = Instant.now();
        TestHttpClient.Answer heard = mia.http()
                .post(
                        follow + "/positions",
                        "{\"sent\":\"" + now + "\",\"positions\":[{\"at\":\"" + now + "\"," + HERE
                                + ",\"accuracy\":5}]}");
        assertThat(heard.status()).as(heard.raw().body()).isEqualTo(200);
    }

    /** The phone says where it is meanwhile. */
    private JsonNode await(String follow, String what, Predicate<JsonNode> condition) {
        return ConditionWait.until(what, () -> {
            says(follow);
            return Optional.of(mia.http().get(follow).json()).filter(condition);
        });
    }

    private static boolean isLedBy(JsonNode follow, String drone) {
        return follow.path("droneName").asString().equals(drone)
                && follow.path("state").asString().equals("tracking");
    }

    private static boolean comes(JsonNode follow, String drone) {
        JsonNode other = follow.path("others").path(0);
        return other.path("droneName").asString("").equals(drone)
                && other.path("comes").asBoolean();
    }

    private static List<String> words(JsonNode follow) {
        return follow.path("told")
                .valueStream()
                .map(one -> one.path("words").asString())
                .toList();
    }

    private static boolean isToldOf(JsonNode message, Predicate<JsonNode> condition) {
        return message.path("type").asString().equals("follow") && condition.test(message.path("follow"));
    }

    private String holderOf(ImmediateCopter copter) {
        Lease tenure =
                house.cloud().controls().control(new DroneId(copter.id())).tenure();
        return tenure == null ? "" : tenure.holder().words();
    }

    @Test
    void replacesADroneThatRunsLowAndAnotherThatFailsOnItsWay() {
        ImmediateCopter kestrel = copter("Kestrel", ASIDE);
        kestrel.staysDown();
        String follow = following();
        String id = follow.substring(PATH.length() + 1);
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, mia.key())) {
            falcon.hasLeft(LOW);
            JsonNode low = await(follow, "Kestrel comes", seen -> comes(seen, "Kestrel"));
            assertThat(isLedBy(low, "Falcon")).isTrue();
            assertThat(words(low))
                    .anyMatch(one -> one.startsWith(
                            "Falcon runs low; Kestrel comes to replace it. Kestrel was chosen: no other"));
            assertThat(faces.soap(mia.http(), "getFollow", Map.of("followId", id)))
                    .contains("<droneName>Falcon</droneName>", "<droneName>Kestrel</droneName>");
            stream.await(message -> isToldOf(message, seen -> comes(seen, "Kestrel")));
            assertThat(holderOf(kestrel)).isEqualTo(holderOf(falcon)).startsWith("The follow");

            ImmediateCopter osprey = copter("Osprey", BESIDE);
            supervisor.post("/api/v1/drones/" + kestrel.id() + "/control/take-over", "{\"reason\":\"a look\"}");
            JsonNode taken = await(follow, "Osprey has taken over", seen -> isLedBy(seen, "Osprey"));
            assertThat(words(taken)).contains("Osprey has taken over; Falcon flies home.");
            stream.await(message -> isToldOf(message, seen -> isLedBy(seen, "Osprey")));
            assertThat(faces.soap(mia.http(), "getFollow", Map.of("followId", id)))
                    .as("the drone that leads, whoever else there still is")
                    .contains("<drone>" + osprey.id() + "</drone><droneName>Osprey</droneName><place>");
            assertThat(holderOf(osprey)).startsWith("The follow");
        }
        ConditionWait.until(
                "Falcon is called home",
                () -> falcon.performed().stream()
                        .filter(Command.ReturnToLaunch.class::isInstance)
                        .findFirst());
        falcon.isOnGround();
        await(follow, "Falcon is free", seen -> holderOf(falcon).isEmpty());
        JournalReplay<?, ?> replay = new JournalReplay<>(house.runs().follows());
        replay.replay(house.runs().operations().journal(new OperationId(id), 0, 200));
        assertThat(replay.difference()).isEmpty();
    }

    @Test
    void saysWhyNoOtherDroneCanComeAndFliesHome() {
        ImmediateCopter kestrel = copter("Kestrel", ASIDE);
        kestrel.hasLeft(30);
        String follow = following();
        falcon.hasLeft(LOW);
        await(
                follow,
                "it says why",
                seen -> words(seen).stream()
                        .anyMatch(one ->
                                one.startsWith("No other drone can replace Falcon. Kestrel: Its battery has 30 %")));
        falcon.hasLeft(19);
        await(follow, "Falcon flies home", seen -> seen.path("state").asString().equals("returning"));
        kestrel.hasLeft(95);
        await(follow, "Kestrel has come after all", seen -> isLedBy(seen, "Kestrel"));
    }

    @Test
    void sendsNoDroneThatSomebodyHasInHand() {
        ImmediateCopter kestrel = copter("Kestrel", ASIDE);
        assertThat(mia.http()
                        .post("/api/v1/drones/" + kestrel.id() + "/control/take", "{}")
                        .status())
                .isEqualTo(200);
        String follow = following();
        falcon.hasLeft(LOW);
        await(
                follow,
                "it says why",
                seen -> words(seen)
                        .contains("No other drone can replace Falcon. No other drone of the warehouse is free."));
        assertThat(kestrel.performed()).isEmpty();
    }
}
