package org.dronemap.proxy.roslink;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.core.command.Setpoint.Facing;
import org.dronemap.core.command.Setpoint.Frame;
import org.dronemap.core.command.Setpoint.Velocity;
import org.dronemap.core.drone.DroneState;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;

/** Robots that are driven and flown by speeds, in stepped time. */
class SteeredRobotTest extends SteppedRobotTestBase {
    private static final Velocity AHEAD = new Velocity(Frame.VEHICLE, 0.4, 0.1, -0.2, new Facing.Turning(90));

    @Test
    void speedsAreSaidInTheRobotsOwnDirections() {
        try (SteppedRobot robot = robot(7, "12")) {
            DroneState drone = still(robot, 7);
            assertThat(steer(drone, AHEAD)).isEmpty();
            JsonNode twist = moving(robot);

            assertThat(twist.path("vx").asDouble()).isEqualTo(0.4);
            assertThat(twist.path("vy").asDouble()).isEqualTo(-0.1);
            assertThat(twist.path("vz").asDouble()).isEqualTo(0.2);
            assertThat(twist.path("wx").asDouble(1)).isZero();
            assertThat(twist.path("wy").asDouble(1)).isZero();
            assertThat(twist.path("wz").asDouble()).isEqualTo(-Math.PI / 2);
        }
    }

    @Test
    void zerosFollowTheLastSpeedsUntilItReportsThatItStands() {
        try (SteppedRobot robot = robot(7, "12")) {
            DroneState drone = still(robot, 7);
            assertThat(steer(drone, AHEAD)).isEmpty();
            moving(robot);
            // Nobody says anything more; six of these may be lost.
            for (int times = 0; times < 8; times++) {
                robot.say(2, "\"x\":0,\"y\":0,\"vx\":0.4,\"vy\":0");
                JsonNode stop = asked(robot, 100);
                assertThat(stop.path("vx").asDouble(1)).isZero();
                assertThat(stop.path("wz").asDouble(1)).isZero();
            }
            await(
                    () -> robot.order(100, QUIET) == null,
                    () -> robot.say(2, "\"x\":0,\"y\":0,\"vx\":0,\"vy\":0,\"wz\":0"));
        }
    }

    @Test
    void nobodySteersByNorthWhatDoesNotTellWhereItLooks() {
        try (SteppedRobot robot = robot(7, "12")) {
            DroneState drone = still(robot, 7);
            String unknown = "Where it looks is not known; steer it by its own forward and right.";
            assertThat(steer(drone, new Velocity(Frame.EARTH, 1, 0, 0, Facing.ANY)))
                    .contains(unknown);
            assertThat(steer(drone, new Velocity(Frame.VEHICLE, 1, 0, 0, new Facing.Heading(90))))
                    .contains(unknown);
        }
    }

    @Test
    void aRobotOfNoKnownKindDrivesWithoutTakingOff() {
        try (SteppedRobot robot = robot(7, "12")) {
            robot.beat(0);
            DroneState drone = awaitDrone(7, state -> state.capabilities().known());
            assertThat(steer(drone, AHEAD)).isEmpty();
            moving(robot);
        }
    }

    @Test
    void aDroneIsSteeredInTheAirAndInGuidedOnly() {
        try (SteppedRobot robot = robot(15, "12")) {
            robot.beat(QUADROTOR);
            awaitDrone(15, state -> state.capabilities().known());
            robot.say(1, "\"state\":3104");
            DroneState drone = awaitDrone(15, state -> Boolean.TRUE.equals(state.armed()));
            assertThat(steer(drone, AHEAD)).contains("Take off first.");
            robot.say(1, "\"state\":4105");
            awaitDrone(15, state -> state.airborne() && "LOITER".equals(state.mode()));
            assertThat(steer(drone, AHEAD))
                    .contains("In LOITER it is not to be steered so; change its mode to GUIDED first.");
            robot.say(1, "\"state\":4104");
            awaitDrone(15, state -> "GUIDED".equals(state.mode()));
            assertThat(steer(drone, AHEAD)).isEmpty();
            assertThat(moving(robot).path("vz").asDouble()).isEqualTo(0.2);
        }
    }
}
