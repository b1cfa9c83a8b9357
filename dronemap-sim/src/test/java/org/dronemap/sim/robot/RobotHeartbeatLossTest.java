package org.dronemap.sim.robot;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Set;
import java.util.function.Supplier;
import org.dronemap.sim.link.ServerAddress;
import org.dronemap.sim.robot.RobotOptions.Identity;
import org.junit.jupiter.api.Test;

/** Simulated robots take the server's heartbeat, and miss it where they are told to. */
class RobotHeartbeatLossTest {
    private static final int TURNS_A_SECOND = 20;

    @Test
    void aRoverStopsOnItsWay() {
        SimulatedRobot rover = robot("rover", 3);
        tell(rover, 101, ",\"x\":3,\"y\":-1,\"z\":0");
        accompany(rover, 2);
        assertThat(rover.truth().speed()).isPositive();
        pass(rover, 2.9);
        assertThat(rover.truth().speed()).isPositive();
        pass(rover, 0.2);
        assertThat(rover.truth().speed()).isZero();
    }

    @Test
    void aRoverThatRepeatsWhatItHeardLastStops() {
        SimulatedRobot rover = robot("rover", 3, BridgeQuirk.REPEATS_TWIST);
        tell(rover, 100, ",\"vx\":0.4,\"wz\":0");
        pass(rover, 2.9);
        assertThat(rover.truth().speed()).isEqualTo(0.4);
        pass(rover, 0.2);
        assertThat(rover.truth().speed()).isZero();
    }

    @Test
    void aDroneLands() {
        SimulatedRobot drone = inTheAir(3);
        accompany(drone, 10);
        assertThat(drone.truth().height()).isEqualTo(2);
        pass(drone, 5);
        assertThat(drone.truth().height()).isZero();
        assertThat(drone.truth().armed()).isFalse();
    }

    @Test
    void whoNeverMissesItGoesOn() {
        SimulatedRobot drone = inTheAir(0);
        accompany(drone, 2);
        pass(drone, 100);
        assertThat(drone.truth().height()).isEqualTo(2);
    }

    private static SimulatedRobot inTheAir(double patience) {
        SimulatedRobot drone = robot("drone", patience);
        tell(drone, 106, ",\"flightMode\":4");
        tell(drone, 104, "");
        tell(drone, 102, ",\"altitude\":2");
        pass(drone, 2);
        return drone;
    }

    private static SimulatedRobot robot(String kind, double patience, BridgeQuirk... quirks) {
        ServerAddress nobody = new ServerAddress(false, "127.0.0.1", 1);
        Identity identity = new Identity(7, "12", "26");
        return new SimulatedRobot(
                new RobotOptions(1, kind, nobody, null, identity, 20, patience, Set.of(quirks)), 0, new Nowhere());
    }

    private record Nowhere() implements SimulatedRobot.Links {
        @Override
        public boolean isOnWeb() {
            return false;
        }

        @Override
        public void sendByWebSocket(Supplier<String> text) {}

        @Override
        public void sendByUdp(String text) {}
    }

    private static void tell(SimulatedRobot robot, int kind, String body) {
        robot.received("{\"header\":{\"system_id\":7,\"message_id\":" + kind + ",\"key\":\"12\"}" + body + "}");
    }

    /** The server is heard for so many seconds. */
    private static void accompany(SimulatedRobot robot, int seconds) {
        for (int second = 0; second < seconds; second++) {
            pass(robot, 1);
            tell(robot, 0, ",\"type\":7,\"name\":\"dronemap\",\"system_status\":2,\"mode\":0");
        }
    }

    private static void pass(SimulatedRobot robot, double seconds) {
        for (int turn = 0; turn < seconds * TURNS_A_SECOND; turn++) {
            robot.advance(1.0 / TURNS_A_SECOND);
        }
    }
}
