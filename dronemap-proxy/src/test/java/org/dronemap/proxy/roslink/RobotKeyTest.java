package org.dronemap.proxy.roslink;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.EmergencyStop;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.LocalPosition;
import org.dronemap.proxy.session.Enrolment;
import org.junit.jupiter.api.Test;

/** Robots with keys on real sockets: those that they were issued to, and those who are not whom they say. */
class RobotKeyTest extends RobotTestBase {
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
                return house.drone(7).messages().stream()
                                .anyMatch(text -> text.text().contains("127.0.0.2"))
                        && house.drone(7).local() != null;
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
            assertThat(thief.ordersWaiting() + thief.heartbeats()).isZero();
            assertThat(house.drone(7).local()).isEqualTo(new LocalPosition(1, 1, null, null));
            assertThat(house.drone(7).link().key().address()).isEqualTo("127.0.0.1");
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
    void aKeyThatIsNotValidLetsNobodyInAndIsReported() throws Exception {
        try (TestRobot wrong = new TestRobot(udp(), 7, "\"rk-of-nobody\"");
                TestRobot known = new TestRobot(udp(), 7, "\"" + SECRET_OF_7 + "\"")) {
            wrong.connect(web(), "/");
            wrong.say(0, "\"type\":8");
            wrong.say(2, "\"x\":99,\"y\":99");
            wrong.sayOnWeb(0, "\"type\":8");
            await(() -> proxy.refusedCount() == 3);
            known.say(0, "\"type\":8");

            assertThat(awaitDrone(7, drone -> drone.capabilities().known()).id())
                    .isEqualTo(TestRobotKeys.ROBOT_7);
            assertThat(house.cloud().drones()).hasSize(1);
            assertThat(house.cloud().waiting()).isEmpty();
            assertThat(house.drone(7).local()).isNull();
        }
    }

    @Test
    void aRevokedKeyEndsTheLinksOfItsRobotAtOnce() throws Exception {
        try (TestRobot robot = new TestRobot(udp(), 7, "\"" + SECRET_OF_7 + "\"");
                TestRobot newer = new TestRobot(udp(), 7, "\"rk-renewed\"")) {
            robot.say(0, "\"type\":8");
            robot.connect(web(), "/");
            robot.sayOnWeb(0, "\"type\":8");
            DroneState drone = awaitDrone(
                    7,
                    state -> state.capabilities().known()
                            && !state.link().others().isEmpty());
            CompletableFuture<Outcome> holding = command(drone, new EmergencyStop());
            assertThat(robot.order(108, 5_000)).isNotNull();

            keys.issue("rk-renewed", TestRobotKeys.ROBOT_7, 7, "12");
            proxy.disconnect(TestRobotKeys.ROBOT_7.value());

            assertThat(holding.get(5, TimeUnit.SECONDS)).isInstanceOf(Outcome.Unknown.class);
            while (robot.ordersWaiting() > 0) {
                robot.order(100, 0);
            }
            robot.say(2, "\"x\":99,\"y\":99");
            robot.sayOnWeb(0, "\"type\":8");
            await(() -> proxy.refusedCount() == 2);
            int heartbeats = robot.heartbeats();
            assertThat(command(drone, new Command.Hold()).get(5, TimeUnit.SECONDS))
                    .isInstanceOf(Outcome.Refused.class);
            assertThat(robot.ordersWaiting()).isZero();

            newer.say(0, "\"type\":8");
            newer.say(2, "\"x\":1,\"y\":2");
            await(() -> {
                newer.say(2, "\"x\":1,\"y\":2");
                return house.drone(7).local() != null;
            });
            assertThat(house.drone(7).id()).isEqualTo(TestRobotKeys.ROBOT_7);
            assertThat(house.drone(7).local()).isEqualTo(new LocalPosition(1, 2, null, null));
            assertThat(robot.ordersWaiting()).isZero();
            await(() -> newer.heartbeats() > 1);
            assertThat(robot.heartbeats()).as("none after its key was void").isEqualTo(heartbeats);
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
            await(() -> known.heartbeats() > 1);
            assertThat(stranger.ordersWaiting() + stranger.heartbeats()).isZero();

            house.cloud().admit(house.cloud().waiting().get(0).id(), "turtle");
            await(() -> {
                beat(stranger);
                return house.cloud().drones().stream()
                        .anyMatch(drone ->
                                drone.name().equals("turtle") && drone.link().state() == LinkState.LIVE);
            });
            await(() -> stranger.heartbeats() > 0);
        }
    }
}
