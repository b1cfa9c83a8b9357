package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.http.HttpRequest;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.lease.Lease;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.ws.testserver.ConditionWait;
import org.dronemap.ws.testserver.ExposedOperations;
import org.dronemap.ws.testserver.FollowStages;
import org.dronemap.ws.testserver.FollowStages.Staged;
import org.dronemap.ws.testserver.OrganisationMember;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * A drone is taken from its follow at each stage, or whoever asked loses the right to it: each face shows what docs/following.md
 * says, and somebody looks after the drone.
 */
class FollowTakenTest {
    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestServer house = tenant.server();
    private ExposedOperations faces;
    private OrganisationMember root;
    private OrganisationMember supervisor;
    private FollowStages stages;

    /** How it comes about. */
    private enum Deed {
        TAKE_OVER("taken"),
        HOLD("taken"),
        LAND("taken"),
        PILOT("taken"),
        GRANT("revoked"),
        ACCOUNT("revoked"),
        /** The account stays, and with it the follow. */
        KEY("");

        private final String row;

        Deed(String row) {
            this.row = row;
        }

        /** One that is not armed takes no orders. */
        boolean does(String stage) {
            return !stage.equals("allocated") || (this != HOLD && this != LAND);
        }

        /** On the ground there is no pilot to be seen. */
        boolean isPossible(String stage) {
            return this != PILOT || !(stage.equals("allocated") || stage.equals("starting"));
        }
    }

    private record Case(Staged follow, Deed deed, OrganisationMember owner, String next) {
        @Override
        public String toString() {
            return deed + " at " + follow.stage();
        }
    }

    @BeforeEach
    void open() {
        faces = new ExposedOperations(house);
        root = tenant.member("root", Role.ADMINISTRATOR);
        supervisor = tenant.member("sue", Role.SUPERVISOR);
        stages = new FollowStages(tenant, supervisor.http());
    }

    @Test
    void leavesNoDroneWithNobodyWhoLooksAfterIt() throws IOException {
        Map<String, Map<String, String>> table = FollowStages.table();
        List<Case> cases = new ArrayList<>();
        for (String stage : table.keySet()) {
            for (Deed deed : Deed.values()) {
                if (!deed.isPossible(stage)) {
                    continue;
                }
                OrganisationMember owner = tenant.member("owner", Role.OPERATOR);
                String next = deed.does(stage) && !deed.row.isEmpty()
                        ? table.get(stage).get(deed.row)
                        : stage;
                cases.add(new Case(stages.open(stage, owner.http()), deed, owner, next));
            }
        }
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, supervisor.key())) {
            stages.bring();
            cases.forEach(this::happens);
            cases.forEach(one -> shows(one, stream));
            cases.forEach(this::isLookedAfter);
        }
    }

    private void happens(Case one) {
        switch (one.deed()) {
            case TAKE_OVER -> {
                stages.takeOver(one.follow());
                assertThat(holder(one)).isEqualTo(new LeaseHolder.Person(supervisor.name()));
            }
            case HOLD -> orders(one, "hold");
            case LAND -> orders(one, "land");
            case PILOT -> one.follow().copter().isIn("LOITER");
            case GRANT ->
                changed("PUT", "/api/v1/users/" + one.owner().name() + "/only-granted", "{\"onlyGranted\":true}");
            case ACCOUNT -> changed("PATCH", "/api/v1/users/" + one.owner().name(), "{\"state\":\"disabled\"}");
            case KEY ->
                assertThat(root.http()
                                .send(
                                        "/api/v1/users/" + one.owner().name() + "/access-keys/key-"
                                                + one.owner().name(),
                                        HttpRequest.Builder::DELETE)
                                .status())
                        .isEqualTo(204);
        }
    }

    private void orders(Case one, String type) {
        int status = supervisor
                .http()
                .post(
                        "/api/v1/drones/" + one.follow().copter().id() + "/commands?wait=30",
                        "{\"type\":\"" + type + "\"}")
                .status();
        assertThat(status)
                .as(one.toString())
                .isEqualTo(one.deed().does(one.follow().stage()) ? 200 : 409);
    }

    private void changed(String method, String path, String body) {
        TestHttpClient.Answer answer = root.http()
                .send(
                        path,
                        request -> request.header("Content-Type", "application/json")
                                .method(method, HttpRequest.BodyPublishers.ofString(body)));
        assertThat(answer.status()).as(answer.raw().body()).isLessThan(300);
    }

    /** By REST, by SOAP and on the stream; whoever lost the right sees nothing of it any more. */
    private void shows(Case one, RecordingStreamClient stream) {
        Staged follow = one.follow();
        stages.await(follow, one.next());
        assertThat(faces.soap(supervisor.http(), "getFollow", Map.of("followId", follow.id())))
                .as(one.toString())
                .contains("<state>" + one.next() + "</state>");
        stream.await(message -> message.path("follow").path("id").asString("").equals(follow.id())
                && message.path("follow").path("state").asString("").equals(one.next()));
        int sees = one.owner().http().get(follow.path()).status();
        assertThat(sees)
                .as(one.toString())
                .isEqualTo(
                        switch (one.deed()) {
                            case GRANT -> 404;
                            case ACCOUNT, KEY -> 401;
                            default -> 200;
                        });
    }

    /** Null: nobody has control. */
    private @Nullable LeaseHolder holder(Case one) {
        Lease tenure = house.cloud()
                .controls()
                .control(new DroneId(one.follow().copter().id()))
                .tenure();
        return tenure == null ? null : tenure.holder();
    }

    private void isLookedAfter(Case one) {
        boolean own = holder(one) instanceof LeaseHolder.Operation by
                && by.id().equals(one.follow().id());
        switch (one.next()) {
            case "over" -> assertThat(own).as(one.toString()).isFalse();
            case "suspended" -> {
                assertThat(own).as(one.toString()).isFalse();
                isLeftTo(one);
            }
            default -> assertThat(own).as(one.toString()).isTrue();
        }
        if (one.next().equals("returning") && !one.follow().stage().equals("starting")) {
            ConditionWait.until(
                    one + ": it is called home",
                    () -> one.follow().copter().performed().stream()
                            .filter(Command.ReturnToLaunch.class::isInstance)
                            .findFirst());
        }
    }

    /** What nobody has, and comes down by itself or is brought home after a while, has a plan. */
    private void isLeftTo(Case one) {
        List<Command> performed = one.follow().copter().performed();
        if (one.deed() == Deed.LAND) {
            assertThat(performed).as(one.toString()).contains(new Command.Land());
        } else if (one.deed() == Deed.HOLD) {
            assertThat(performed).as(one.toString()).contains(new Command.Hold());
            if (!one.follow().stage().equals("suspended")) {
                ConditionWait.until(
                        one + ": it says what comes of it",
                        () -> Optional.of(supervisor
                                        .http()
                                        .get(one.follow().path())
                                        .text("note"))
                                .filter(note -> note.startsWith("Nobody has Copter")));
            }
        }
    }
}
