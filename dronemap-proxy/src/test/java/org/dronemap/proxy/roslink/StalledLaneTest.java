package org.dronemap.proxy.roslink;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.CountDownLatch;
import java.util.stream.IntStream;
import org.dronemap.core.drone.DroneId;
import org.junit.jupiter.api.Test;

/** A robot whose lane stands still hears nothing from a server that lives on, and hears it. */
class StalledLaneTest extends RobotTestBase {
    @Test
    void itsHeartbeatsStopWithItsLaneAndGoOnWithIt() throws Exception {
        DroneId first = new DroneId("drobot0100");
        keys.issue("rk-first", first, 9, null);
        keys.issue("rk-other", onAnotherLaneThan(first), 10, null);
        try (TestRobot robot = new TestRobot(udp(), 9, "\"rk-first\"");
                TestRobot other = new TestRobot(udp(), 10, "\"rk-other\"")) {
            await(() -> {
                beat(robot);
                beat(other);
                return robot.heartbeats() > 1 && other.heartbeats() > 1;
            });
            CountDownLatch goesOn = new CountDownLatch(1);
            stall(first, goesOn);
            int settled = other.heartbeats() + 1;
            await(() -> other.heartbeats() >= settled);
            int before = robot.heartbeats();
            int after = other.heartbeats() + 3;
            await(() -> {
                beat(robot);
                return other.heartbeats() >= after;
            });
            assertThat(robot.heartbeats()).isEqualTo(before);

            goesOn.countDown();
            await(() -> robot.heartbeats() > before + 1);
        }
    }

    private DroneId onAnotherLaneThan(DroneId one) {
        return IntStream.range(101, 200)
                .mapToObj(number -> new DroneId("drobot0" + number))
                .filter(drone -> house.lanes().of(drone) != house.lanes().of(one))
                .findFirst()
                .orElseThrow();
    }

    /** From when this returns. */
    private void stall(DroneId drone, CountDownLatch goesOn) throws InterruptedException {
        CountDownLatch stands = new CountDownLatch(1);
        house.lanes().of(drone).execute(() -> {
            stands.countDown();
            try {
                goesOn.await();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        });
        stands.await();
    }
}
