package org.dronemap.proxy.roslink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.TextMessage;
import org.dronemap.proxy.endpoint.MemoryLink;
import org.dronemap.proxy.endpoint.PeerAddress;
import org.dronemap.proxy.roslink.wire.RobotOrder;
import org.junit.jupiter.api.Test;

/** Robots hear that the cloud is there, each as it speaks itself, as long as its lane works and the robot is known. */
class CloudHeartbeatSenderTest extends SteppedRobotTestBase {
    /** As the bridge of a drone behind mavros sends it. */
    private static final String BRIDGE =
            "{\"name\": \"Gapter\", \"mode\": 0, \"header\": {\"sequence_number\": 41, \"ros_version\": 8, \"system_id\": 15, "
                    + "\"key\": \"1243-0000-0000-FGFG\", \"roslink_version\": 1, \"message_id\": 0, \"owner_id\": 3}, "
                    + "\"owner_id\": 3, \"system_status\": 2, \"type\": 3}";
    /** As the papers print it. */
    private static final String PAPER =
            "{\"roslink_version\":2,\"ros_version\":9,\"system_id\":300,\"message_id\":0,\"sequence_number\":5,"
                    + "\"payload\":{\"type\":3,\"name\":\"drone\",\"system_status\":2,\"owner_id\":\"maram\",\"mode\":0}}";

    private static final Duration SECOND = Duration.ofSeconds(1);
    private static final int SECONDS = 30;

    @Test
    void aBridgeHearsItWithAHeaderAsItsOwn() {
        assertThat(heard(BRIDGE).get(0))
                .isEqualTo("{\"header\":{\"roslink_version\":1,\"ros_version\":8,\"system_id\":15,\"message_id\":0,"
                        + "\"sequence_number\":1,\"key\":\"1243-0000-0000-FGFG\",\"owner_id\":3},"
                        + "\"type\":7,\"name\":\"dronemap\",\"system_status\":2,\"owner_id\":3,\"mode\":0}");
    }

    @Test
    void aRobotOfThePapersHearsItWithAPayloadAndInItsOwnVersion() {
        assertThat(heard(PAPER).get(0))
                .isEqualTo("{\"roslink_version\":2,\"ros_version\":9,\"system_id\":300,\"message_id\":0,"
                        + "\"sequence_number\":1,\"owner_id\":\"maram\",\"payload\":{\"type\":7,\"name\":\"dronemap\","
                        + "\"system_status\":2,\"owner_id\":\"maram\",\"mode\":0}}");
    }

    @Test
    void itComesOnceASecond() {
        assertThat(heard(BRIDGE).size()).isBetween(SECONDS - 2, SECONDS + 1);
        assertThat(heard(PAPER).size()).isBetween(SECONDS - 2, SECONDS + 1);
    }

    /** What a robot hears on its datagrams that says that, once a second, and nothing else. */
    private List<String> heard(String said) {
        List<String> heard = new ArrayList<>();
        try (MemoryLink link = new MemoryLink(
                proxy.handlers(),
                new PeerAddress("127.0.0.1", 14_000 + said.length()),
                bytes -> heard.add(new String(bytes, StandardCharsets.UTF_8)),
                time)) {
            assertThat(heard).as("before it has called in").isEmpty();
            for (int second = 0; second < SECONDS; second++) {
                link.received(said.getBytes(StandardCharsets.UTF_8));
                time.advance(SECOND);
            }
        }
        return heard;
    }

    @Test
    void aRobotOnBothLinksHearsItOnBoth() {
        try (SteppedRobot robot = robot(7, "12")) {
            robot.connect();
            await(
                    () -> house.cloud().drones().size() == 1
                            && house.drone(7).link().others().size() == 1,
                    () -> beatOnBoth(robot));
            int before = robot.heartbeats();
            for (int second = 0; second < 10; second++) {
                beatOnBoth(robot);
                time.advance(SECOND);
            }
            assertThat(robot.heartbeats() - before).isBetween(18, 21);
        }
    }

    private static void beatOnBoth(SteppedRobot robot) {
        robot.beat(TURTLEBOT);
        robot.sayOnWeb(0, "\"type\":" + TURTLEBOT);
    }

    /** It may hear though it is not heard; but not for ever, as somebody else may get its address. */
    @Test
    void itGoesOnWhileTheRobotIsSilentAndEndsWithItsSession() {
        try (SteppedRobot robot = robot(7, "12")) {
            robot.beat(TURTLEBOT);
            DroneState drone = awaitDrone(7, state -> state.capabilities().known());
            int before = robot.heartbeats();
            time.advance(Duration.ofSeconds(20));
            assertThat(house.cloud().drone(drone.id()).orElseThrow().link().state())
                    .isEqualTo(LinkState.LOST);
            assertThat(robot.heartbeats() - before).isBetween(18, 21);

            time.advance(Duration.ofMinutes(2));
            int end = robot.heartbeats();
            time.advance(Duration.ofMinutes(1));
            assertThat(robot.heartbeats()).isEqualTo(end);
        }
    }

    @Test
    void itsPageSaysThatNobodyKnowsWhatItDoesWithoutTheCloud() {
        try (SteppedRobot robot = robot(7, "12")) {
            robot.beat(TURTLEBOT);
            DroneState drone = awaitDrone(7, state -> state.capabilities().known());
            assertThat(drone.messages())
                    .extracting(TextMessage::text)
                    .containsOnlyOnce(
                            "What it does when the cloud falls silent is not known: robots over ROSLink do not tell.");
        }
    }

    @Test
    void aLaneThatStoodStillMakesUpForNothing() {
        List<RobotOrder> said = new ArrayList<>();
        CloudHeartbeatSender heartbeat = new CloudHeartbeatSender(said::add);
        long second = SECOND.toNanos();
        heartbeat.sendDue(-5);
        heartbeat.sendDue(second - 6);
        assertThat(said).hasSize(1);
        heartbeat.sendDue(20 * second);
        heartbeat.sendDue(20 * second + 20_000_000);
        assertThat(said).hasSize(2).containsOnly(new RobotOrder.Heartbeat());
    }
}
