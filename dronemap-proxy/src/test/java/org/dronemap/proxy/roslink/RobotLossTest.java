package org.dronemap.proxy.roslink;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.concurrent.CountDownLatch;
import org.dronemap.proxy.session.VehicleTraffic;
import org.junit.jupiter.api.Test;

/** What is missing of what robots number, by whichever links they have; they may number all of it in one row. */
class RobotLossTest extends RobotTestBase {
    private static final int TIMES = 30;
    private static final String BEAT = "\"type\":8";
    private static final String MOTION = "\"x\":1,\"y\":1";

    @Test
    void whatComesByTheOtherLinkIsNotLost() throws Exception {
        try (TestRobot robot = onBothLinks()) {
            say(robot, false);
            long before = on("udp").lost();
            say(robot, false);

            assertThat(on("udp").lost()).isEqualTo(before).isZero();
            assertThat(on("websocket").lost()).isZero();
        }
    }

    @Test
    void whatComesByNoLinkGotLostAmongDatagrams() throws Exception {
        try (TestRobot robot = onBothLinks()) {
            say(robot, false);
            long before = on("udp").lost();
            say(robot, true);

            assertThat(on("udp").lost()).isEqualTo(before + TIMES);
            assertThat(on("websocket").lost()).isZero();
            assertThat(proxy.endpoints().get(0).counts().lost()).isGreaterThanOrEqualTo(TIMES);
        }
    }

    /** As on a machine that has no time when its robots call in. */
    @Test
    void whatARobotSaidUntilItsOtherLinkWasTakenInIsNotLost() throws Exception {
        try (TestRobot robot = new TestRobot(udp(), 7, "\"" + SECRET_OF_7 + "\"")) {
            robot.connect(web(), "/");
            await(() -> {
                robot.sayOnWeb(0, BEAT);
                return house.cloud().drones().size() == 1;
            });
            CountDownLatch busy = new CountDownLatch(1);
            house.lanes().registry().execute(() -> awaitOnce(busy));
            robot.say(0, BEAT);
            await(() -> proxy.traffic().size() == 2);
            for (int i = 0; i < TIMES; i++) {
                robot.sayOnWeb(2, MOTION);
            }
            // All but the one datagram: heartbeats of the beginning may be on their way still.
            await(() -> on("websocket").received() == robot.numbered() - 1);
            busy.countDown();
            await(() -> house.drone(7).link().others().size() == 1);
            say(robot, false);

            assertThat(on("udp").lost()).isZero();
            assertThat(on("websocket").lost()).isZero();
        }
    }

    private static void awaitOnce(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Turn by turn, each once all of the one before has come. */
    private void say(TestRobot robot, boolean losingOne) throws IOException {
        for (int i = 0; i < TIMES; i++) {
            long byWeb = on("websocket").received();
            long byUdp = on("udp").received();
            robot.sayOnWeb(0, BEAT);
            robot.sayOnWeb(2, MOTION);
            if (losingOne) {
                // Nobody hears this one.
                robot.packet(0, BEAT);
            }
            robot.say(0, BEAT);
            await(() -> on("websocket").received() >= byWeb + 2 && on("udp").received() > byUdp);
        }
    }

    private TestRobot onBothLinks() throws IOException {
        TestRobot robot = new TestRobot(udp(), 7, "\"" + SECRET_OF_7 + "\"");
        robot.connect(web(), "/");
        await(() -> {
            robot.say(0, BEAT);
            robot.sayOnWeb(0, BEAT);
            return house.cloud().drones().size() == 1
                    && house.drone(7).link().others().size() == 1;
        });
        // None is on its way any more: what is awaited from here on would else be done before its own turn.
        await(() -> on("websocket").received() + on("udp").received() == robot.numbered());
        return robot;
    }

    private VehicleTraffic on(String transport) {
        return proxy.traffic().stream()
                .filter(traffic -> traffic.transport().equals(transport))
                .findFirst()
                .orElseThrow();
    }
}
