package org.dronemap.proxy.roslink;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import org.dronemap.core.command.EmergencyStop;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LocalPosition;
import org.dronemap.core.drone.SensorSnapshot;
import org.dronemap.proxy.session.Enrolment;
import org.junit.jupiter.api.Test;

/**
 * Every kind of message, over UDP and both paths of WebSockets, by those who are not whom they say: nothing of it reaches the
 * robot's drone, nothing that is meant for the robot reaches them, and each is counted.
 */
class RobotMatrixTest extends RobotTestBase {
    private static final String PICTURE = "\"data\":\"/9j/4AEC\"";
    private static final Map<Integer, String> BODIES = Map.of(
            0, "\"type\":8",
            1, "\"state\":1,\"voltage_battery\":66,\"battery_remaining\":66",
            2, "\"x\":66,\"y\":66,\"z\":1,\"vx\":6,\"vy\":6",
            3, "\"fix_type\":3,\"lat\":24.5,\"lon\":46.5,\"satellites_visible\":9",
            4, "\"angle_min\":0,\"angle_increment\":1,\"ranges\":[1,2,3]",
            5, PICTURE,
            6, PICTURE + ",\"width\":20,\"height\":20",
            7, PICTURE + ",\"lat\":24.5,\"lon\":46.5");

    private final List<TestRobot> liars = new ArrayList<>();

    /** What somebody shows who wants to be robot 7. */
    private record ForgedIdentity(String key, String host) {}

    private static final List<ForgedIdentity> LIES = List.of(
            // a key that is void, another robot's, a word of its own, and the right one from elsewhere
            new ForgedIdentity("rk-of-nobody", "127.0.0.1"),
            new ForgedIdentity(TestRobotKeys.OF_8, "127.0.0.1"),
            new ForgedIdentity("12", "127.0.0.1"),
            new ForgedIdentity(TestRobotKeys.OF_7, "127.0.0.2"));

    @Test
    void nothingOfALiarReachesADroneAndNothingOfTheDroneALiar() throws Exception {
        proxy.close();
        proxy = open(Enrolment.NOWHERE);
        proxy.start();
        try (TestRobot seven = new TestRobot(udp(), 7, quoted(TestRobotKeys.OF_7));
                TestRobot eight = new TestRobot(udp(), 8, quoted(TestRobotKeys.OF_8))) {
            seven.connect(web(), "/websockets/roslink/user/12/robot/" + TestRobotKeys.OF_7 + "/robot");
            live(seven);
            live(eight);
            await(() -> {
                live(seven);
                live(eight);
                return house.cloud().drones().size() == 2
                        && house.drone(7).link().others().size() == 1
                        && house.drone(7).local() != null
                        && house.drone(8).local() != null;
            });
            for (ForgedIdentity lie : LIES) {
                lie(lie, seven, eight);
            }
            DroneState truth = house.drone(7);
            CompletableFuture<Outcome> stopping = command(truth, new EmergencyStop());
            assertThat(seven.order(108, 5_000)).isNotNull();
            while (!stopping.isDone()) {
                live(seven);
                seven.order(100, 20);
            }

            unchanged(7);
            unchanged(8);
            assertThat(house.cloud().drones()).hasSize(2);
            assertThat(eight.order(108, 0)).isNull();
            assertThat(liars)
                    .hasSize(12)
                    .allSatisfy(liar ->
                            assertThat(liar.ordersWaiting() + liar.heartbeats()).isZero());
        } finally {
            liars.forEach(TestRobot::close);
        }
    }

    private void unchanged(int systemId) {
        DroneState drone = house.drone(systemId);
        assertThat(drone.local()).isEqualTo(new LocalPosition(1, 1, null, null));
        assertThat(drone.battery()).isNull();
        assertThat(drone.gps()).isNull();
        assertThat(drone.position()).isNull();
        assertThat(house.cloud().sensed(drone.id())).isEqualTo(SensorSnapshot.NOTHING);
    }

    /** By each way, each kind of message twice, and each way is counted. */
    private void lie(ForgedIdentity lie, TestRobot seven, TestRobot eight) throws IOException {
        for (String path : List.of("udp", "/", "/websockets/roslink/user/12/robot/" + lie.key() + "/robot")) {
            TestRobot liar = new TestRobot(udp(), 7, quoted(lie.key()));
            liars.add(liar);
            liar.moveTo(lie.host());
            if (!path.equals("udp")) {
                liar.connect(web(), path);
            }
            long before = proxy.refusedCount();
            await(() -> {
                for (Map.Entry<Integer, String> body : BODIES.entrySet()) {
                    if (path.equals("udp")) {
                        liar.say(body.getKey(), body.getValue());
                    } else {
                        liar.sayOnWeb(body.getKey(), body.getValue());
                    }
                }
                live(seven);
                live(eight);
                return proxy.refusedCount() > before + 1;
            });
        }
    }

    private static void live(TestRobot robot) throws IOException {
        robot.say(0, "\"type\":8");
        robot.sayOnWeb(0, "\"type\":8");
        robot.say(2, "\"x\":1,\"y\":1,\"vx\":0,\"vy\":0");
    }

    private static String quoted(String key) {
        return '"' + key + '"';
    }
}
