package org.dronemap.proxy.roslink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Objects;
import java.util.concurrent.CompletableFuture;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.EmergencyStop;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LocalPosition;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;

/** Robots on real sockets, as public bridges speak. */
class RoslinkProxyTest extends RobotTestBase {
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
                return house.drone(15).link().key().port() == robot.port();
            });

            assertThat(house.cloud().drones()).hasSize(1);
            assertThat(house.drone(15).id()).isEqualTo(first.id());
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
                return house.drone(7).link().others().size() == 1
                        && house.drone(8).link().others().size() == 1
                        && house.drone(8).local() != null;
            });

            assertThat(house.cloud().drones()).hasSize(2);
            assertThat(house.drone(7).link().transport()).isEqualTo("websocket");
            assertThat(house.drone(8).local()).isEqualTo(new LocalPosition(1.5, 2, null, 0.0));
            assertThat(house.drone(7).local()).as("nothing of one at the other").isNull();
            assertThat(house.drone(7).standing().linkIdentity()).isEqualTo(TestRobotKeys.ROBOT_7.value());

            keyed.disconnect();
            await(() -> {
                keyed.say(0, "\"type\":8");
                return house.drone(8).link().transport().equals("udp");
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

            CompletableFuture<Outcome> stopping = command(drone, new EmergencyStop());
            assertThat(seven.order(108, 5_000)).isNotNull();
            while (!stopping.isDone()) {
                seven.say(2, "\"x\":0,\"y\":0,\"vx\":0,\"vy\":0");
                seven.order(100, 100);
            }

            assertThat(eight.order(108, 0)).isNull();
        }
    }

    @Test
    void aGroundRobotIsToldToStandStillFirstOfAll() throws Exception {
        try (TestRobot robot = new TestRobot(udp(), 7, "12")) {
            robot.beat(TURTLEBOT);
            JsonNode order = robot.order(100, 5_000);
            assertThat(order).isNotNull();
            for (String axis : List.of("vx", "vy", "vz", "wx", "wy", "wz")) {
                assertThat(order.path(axis).asDouble(1)).isZero();
            }
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
}
