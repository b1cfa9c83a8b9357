package org.dronemap.proxy.roslink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.LocalPosition;
import org.dronemap.proxy.TestCloud;
import org.dronemap.proxy.endpoint.Doors;
import org.dronemap.proxy.endpoint.DtlsKeys;
import org.dronemap.proxy.endpoint.EndpointUrl;
import org.dronemap.proxy.session.Enrolment;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;

/** Robots on real sockets: as public bridges speak, and as those do who are not whom they say. */
class RoslinkProxyTest {
    private static final Duration PATIENCE = Duration.ofSeconds(15);
    private static final int TURTLEBOT = 8;
    private static final int QUADROTOR = 3;
    private static final String SECRET_OF_7 = "key-of-seven";
    private static final String SECRET_OF_8 = "key-of-eight";
    private static final Map<String, RobotKeys.Issued> ISSUED = Map.of(
            SECRET_OF_7, new RobotKeys.Issued("robot-seven", 7, "12"),
            SECRET_OF_8, new RobotKeys.Issued("robot-eight", 8, "26"));

    private final TestCloud house = new TestCloud(0);
    private RoslinkProxy proxy = open(Enrolment.LOOPBACK);

    @BeforeEach
    void start() throws IOException {
        proxy.start();
    }

    @AfterEach
    void stop() {
        proxy.close();
        house.close();
    }

    private RoslinkProxy open(Enrolment enrolment) {
        return new RoslinkProxy(
                house.cloud(),
                house.lanes(),
                List.of(EndpointUrl.parse("udpserver://127.0.0.1:0"), EndpointUrl.parse("wsserver://127.0.0.1:0")),
                new RoslinkProxy.Policy(
                        key -> Optional.ofNullable(ISSUED.get(key)), Doors.of(DtlsKeys.none()), enrolment));
    }

    private int udp() {
        return proxy.endpoints().get(0).url().port();
    }

    private int web() {
        return proxy.endpoints().get(1).url().port();
    }

    @Test
    void aDroneOnUdpIsSeenAndObeysOnThePortThatItSpeaksFrom() throws Exception {
        try (TestRobot robot = new TestRobot(udp(), 15, "\"1243-0000-0000-FGFG\"")) {
            robot.beat(QUADROTOR);
            DroneState seen = awaitDrone(15, drone -> drone.capabilities().known());
            assertThat(seen.link().key().port()).isEqualTo(robot.port());
            assertThat(seen.battery()).isNull();
            assertThat(seen.position()).isNull();
            robot.say(1, "\"state\":3004");
            awaitDrone(15, drone -> "GUIDED".equals(drone.mode()));

            CompletableFuture<Outcome> arming = command(seen, new Command.Arm());
            JsonNode order = Objects.requireNonNull(robot.order(104, 5_000));
            assertThat(order.get("header").get("key").stringValue()).isEqualTo("1243-0000-0000-FGFG");
            while (!arming.isDone()) {
                robot.say(1, "\"state\":3104");
                robot.order(104, 100);
            }

            assertThat(arming.get()).isEqualTo(new Outcome.Succeeded());
            assertThat(awaitDrone(15, drone -> Boolean.TRUE.equals(drone.armed()))
                            .armed())
                    .isTrue();
        }
    }

    @Test
    void ordersFollowARobotWhosePortChanges() throws Exception {
        try (TestRobot robot = new TestRobot(udp(), 15, "12")) {
            robot.beat(TURTLEBOT);
            DroneState first = awaitDrone(15, drone -> drone.capabilities().known());
            robot.moveTo("127.0.0.1");
            await(() -> {
                beat(robot);
                return drone(15).link().key().port() == robot.port();
            });

            assertThat(house.cloud().drones()).hasSize(1);
            assertThat(drone(15).id()).isEqualTo(first.id());
            CompletableFuture<Outcome> holding = command(first, new Command.Hold());
            assertThat(robot.order(100, 5_000)).isNotNull();
            robot.say(2, "\"x\":0,\"y\":0,\"vx\":0,\"vy\":0");
            while (!holding.isDone()) {
                robot.say(2, "\"x\":0,\"y\":0,\"vx\":0,\"vy\":0");
                robot.order(100, 100);
            }
            assertThat(holding.get()).isEqualTo(new Outcome.Succeeded());
        }
    }

    @Test
    void heartbeatsOverUdpAndWebSocketMakeOneRobotOnEitherPath() throws Exception {
        try (TestRobot bare = new TestRobot(udp(), 7, "\"" + SECRET_OF_7 + "\"");
                TestRobot keyed = new TestRobot(udp(), 8, "\"" + SECRET_OF_8 + "\"")) {
            bare.connect(web(), "/");
            keyed.connect(web(), "/websockets/roslink/user/26/robot/" + SECRET_OF_8 + "/robot");
            for (TestRobot robot : List.of(bare, keyed)) {
                robot.sayOnWeb(0, "\"type\":8");
            }
            awaitDrone(7, drone -> drone.capabilities().known());
            awaitDrone(8, drone -> drone.capabilities().known());
            await(() -> {
                bare.say(0, "\"type\":8");
                bare.sayOnWeb(1, "\"type\":8,\"name\":\"a heartbeat in the place of a status\"");
                keyed.say(0, "\"type\":8");
                keyed.sayOnWeb(2, "\"x\":1.5,\"y\":2,\"z\":0");
                return drone(7).link().others().size() == 1
                        && drone(8).link().others().size() == 1
                        && drone(8).local() != null;
            });

            assertThat(house.cloud().drones()).hasSize(2);
            assertThat(drone(7).link().transport()).isEqualTo("websocket");
            assertThat(drone(8).local()).isEqualTo(new LocalPosition(1.5, 2, null, 0.0));
            assertThat(drone(7).local()).as("nothing of one at the other").isNull();
            assertThat(drone(7).standing().linkIdentity()).isEqualTo("robot-seven");

            keyed.disconnect();
            await(() -> {
                keyed.say(0, "\"type\":8");
                return drone(8).link().transport().equals("udp");
            });
        }
    }

    @Test
    void whatIsMeantForOneRobotReachesNoOther() throws Exception {
        try (TestRobot seven = new TestRobot(udp(), 7, "\"" + SECRET_OF_7 + "\"");
                TestRobot eight = new TestRobot(udp(), 8, "\"" + SECRET_OF_8 + "\"")) {
            eight.say(0, "\"type\":8");
            eight.connect(web(), "/");
            eight.sayOnWeb(0, "\"type\":8");
            seven.say(0, "\"type\":8");
            awaitDrone(8, drone -> drone.capabilities().known());
            DroneState drone = awaitDrone(7, state -> state.capabilities().known());

            CompletableFuture<Outcome> holding = command(drone, new Command.Hold());
            assertThat(seven.order(100, 5_000)).isNotNull();
            while (!holding.isDone()) {
                seven.say(2, "\"x\":0,\"y\":0,\"vx\":0,\"vy\":0");
                seven.order(100, 100);
            }

            assertThat(eight.ordersWaiting()).isZero();
        }
    }

    @Test
    void theRightKeyFromASecondAddressDivertsNothingWhileTheFirstLives() throws Exception {
        try (TestRobot robot = new TestRobot(udp(), 7, "\"" + SECRET_OF_7 + "\"");
                TestRobot thief = new TestRobot(udp(), 7, "\"" + SECRET_OF_7 + "\"")) {
            thief.moveTo("127.0.0.2");
            robot.say(0, "\"type\":8");
            robot.say(2, "\"x\":1,\"y\":1");
            DroneState drone = awaitDrone(7, state -> state.capabilities().known());
            await(() -> {
                robot.say(0, "\"type\":8");
                robot.say(2, "\"x\":1,\"y\":1");
                thief.say(0, "\"type\":8");
                thief.say(2, "\"x\":99,\"y\":99");
                return drone(7).messages().stream().anyMatch(text -> text.text().contains("127.0.0.2"))
                        && drone(7).local() != null;
            });
            long refused = proxy.refusedCount();
            CompletableFuture<Outcome> holding = command(drone, new Command.Hold());
            assertThat(robot.order(100, 5_000)).isNotNull();
            while (!holding.isDone()) {
                thief.say(0, "\"type\":8");
                thief.say(2, "\"x\":99,\"y\":99,\"vx\":9,\"vy\":9");
                robot.say(2, "\"x\":1,\"y\":1,\"vx\":0,\"vy\":0");
                robot.order(100, 50);
            }

            assertThat(refused).isPositive();
            assertThat(thief.ordersWaiting()).isZero();
            assertThat(drone(7).local()).isEqualTo(new LocalPosition(1, 1, null, null));
            assertThat(drone(7).link().key().address()).isEqualTo("127.0.0.1");
            assertThat(house.cloud().drones()).hasSize(1);
        }
    }

    @Test
    void aKeyIsGoodForItsOwnSystemIdAndOwnerOnly() throws Exception {
        try (TestRobot other = new TestRobot(udp(), 8, "\"" + SECRET_OF_7 + "\"");
                TestRobot owned = new TestRobot(udp(), 7, "\"" + SECRET_OF_7 + "\"");
                TestRobot lying = new TestRobot(udp(), 7, "\"" + SECRET_OF_7 + "\"")) {
            other.say(0, "\"type\":8");
            owned.say(0, "\"type\":8,\"owner_id\":26");
            lying.connect(web(), "/websockets/roslink/user/26/robot/" + SECRET_OF_8 + "/robot");
            lying.sayOnWeb(0, "\"type\":8");
            await(() -> proxy.refusedCount() == 3);
            assertThat(house.cloud().drones()).isEmpty();

            owned.say(0, "\"type\":8,\"owner_id\":\"12\"");
            awaitDrone(7, drone -> drone.standing().strongest().isProof());
        }
    }

    @Test
    void aWrongKeySpeaksForNobodyElse() throws Exception {
        try (TestRobot robot = new TestRobot(udp(), 7, "\"" + SECRET_OF_7 + "\"");
                TestRobot wrong = new TestRobot(udp(), 7, "\"another\"")) {
            robot.say(0, "\"type\":8");
            DroneState drone = awaitDrone(7, state -> state.capabilities().known());
            wrong.beat(TURTLEBOT);
            wrong.say(2, "\"x\":99,\"y\":99");
            await(() -> house.cloud().drones().size() == 2);
            // From the robot's own port, but with another key than it came with.
            robot.sayRaw(wrong.packet(2, "\"x\":66,\"y\":66"));
            await(() -> proxy.refusedCount() == 1);

            DroneState now = house.cloud().drone(drone.id()).orElseThrow();
            assertThat(now.local()).isNull();
            assertThat(now.link().key().port()).isEqualTo(robot.port());
        }
    }

    @Test
    void aStrangerFromElsewhereWaitsUntilSomebodyLetsItIn() throws Exception {
        proxy.close();
        proxy = open(Enrolment.NOWHERE);
        proxy.start();
        try (TestRobot stranger = new TestRobot(udp(), 5, "12");
                TestRobot known = new TestRobot(udp(), 8, "\"" + SECRET_OF_8 + "\"")) {
            await(() -> {
                beat(stranger);
                return house.cloud().waiting().size() == 1;
            });
            known.say(0, "\"type\":8");
            awaitDrone(8, drone -> true);
            assertThat(house.cloud().drones()).hasSize(1);
            assertThat(stranger.ordersWaiting()).isZero();

            house.cloud().letIn(house.cloud().waiting().get(0).id(), "turtle");
            await(() -> {
                beat(stranger);
                return house.cloud().drones().stream()
                        .anyMatch(drone ->
                                drone.name().equals("turtle") && drone.link().state() == LinkState.LIVE);
            });
        }
    }

    @Test
    void hostileMessagesEndNoSession() throws Exception {
        try (TestRobot robot = new TestRobot(udp(), 7, "12")) {
            robot.beat(TURTLEBOT);
            awaitDrone(7, drone -> drone.capabilities().known());
            String deep = "{\"header\":" + "[".repeat(100);
            for (String text : List.of("", "{", "null", "[1]", deep, "\u0000", "{\"header\":{}}")) {
                robot.sayRaw(text);
            }
            await(() -> proxy.brokenCount() >= 6);
            robot.say(5, "\"data\":\"" + "A".repeat(60_000) + "\"");
            robot.say(2, "\"x\":4,\"y\":5");

            awaitDrone(7, drone -> drone.local() != null);
            assertThat(proxy.endpoints().get(0).counts().brokenBytes()).isPositive();
        }
    }

    @Test
    void anImageOfTwoHundredKilobytesComesOverAWebSocket() throws Exception {
        try (TestRobot robot = new TestRobot(udp(), 7, "12")) {
            robot.connect(web(), "/");
            robot.sayOnWeb(0, "\"type\":8");
            awaitDrone(7, drone -> drone.capabilities().known());
            robot.sayOnWeb(5, "\"data\":\"" + "QUJD\\n".repeat(50_000) + "\"");
            robot.sayOnWeb(2, "\"x\":4,\"y\":5");

            awaitDrone(7, drone -> drone.local() != null);
            assertThat(proxy.brokenCount()).isZero();
        }
    }

    @Test
    void nobodyIsLetInOnAnotherPath() {
        assertThatThrownBy(() -> {
                    try (TestRobot robot = new TestRobot(udp(), 7, "12")) {
                        robot.connect(web(), "/websockets/roslink/user/1/robot/12/user");
                    }
                })
                .hasRootCauseInstanceOf(Exception.class);
        assertThat(house.cloud().drones()).isEmpty();
    }

    private CompletableFuture<Outcome> command(DroneState drone, Command command) {
        return CompletableFuture.supplyAsync(() -> house.command(drone.id(), command))
                .orTimeout(30, TimeUnit.SECONDS);
    }

    private static void beat(TestRobot robot) throws IOException {
        robot.beat(TURTLEBOT);
    }

    private DroneState drone(int systemId) {
        return house.cloud().drones().stream()
                .filter(drone -> drone.link().key().systemId() == systemId)
                .findFirst()
                .orElseThrow();
    }

    private DroneState awaitDrone(int systemId, Predicate<DroneState> wanted) {
        return TestCloud.await(
                PATIENCE,
                () -> house.cloud().drones().stream()
                        .filter(drone -> drone.link().key().systemId() == systemId)
                        .filter(wanted)
                        .findFirst(),
                () -> "no drone as wanted among " + house.cloud().drones());
    }

    /** Something that may be tried again and again. */
    private interface Look {
        boolean isThere() throws IOException;
    }

    private void await(Look look) {
        TestCloud.await(
                PATIENCE,
                () -> {
                    try {
                        return look.isThere();
                    } catch (IOException e) {
                        throw new AssertionError(e);
                    }
                },
                () -> "not there: " + house.cloud().drones() + ", refused " + proxy.refusedCount() + ", broken "
                        + proxy.brokenCount());
    }
}
