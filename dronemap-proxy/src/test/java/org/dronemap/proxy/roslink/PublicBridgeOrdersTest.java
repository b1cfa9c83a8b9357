package org.dronemap.proxy.roslink;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.Future;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.Setpoint.Facing;
import org.dronemap.core.command.Setpoint.Frame;
import org.dronemap.core.command.Setpoint.Velocity;
import org.dronemap.core.drone.DroneState;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;

/** Orders to public bridges, and silence, which stepped time waits for. */
class PublicBridgeOrdersTest extends SteppedRobotTestBase {
    private static final int GAPTER = 2;
    private static final Velocity AHEAD = new Velocity(Frame.VEHICLE, 0.4, 0, 0, Facing.ANY);
    private static final String IN_THE_AIR = "\"state\":4104";
    private static final String QUOTED_7 = "\"" + TestRobotKeys.OF_7 + "\"";
    private static final String QUOTED_8 = "\"" + TestRobotKeys.OF_8 + "\"";

    @Test
    void theGapterOnUdpTakesItsOrdersOnThePortThatItSpeaksFrom() {
        try (SteppedRobot gapter = robot(1, "\"1243-0000-0000-FGFG\"")) {
            await(() -> house.cloud().drones().stream().anyMatch(drone -> Boolean.TRUE.equals(drone.armed())), () -> {
                gapter.beat(GAPTER);
                gapter.say(1, "\"state\":3100");
            });
            DroneState drone = house.drone(1);

            Future<CommandRecord> takingOff = command(drone, new Command.TakeOff(1));
            assertThat(asked(gapter, 106).get("flightMode").intValue()).isEqualTo(4);
            gapter.say(1, "\"state\":3104");
            assertThat(asked(gapter, 102).get("altitude").doubleValue()).isEqualTo(1);
            await(takingOff::isDone, () -> {
                gapter.say(1, IN_THE_AIR);
                gapter.say(2, "\"x\":0,\"y\":0,\"z\":1," + STANDS);
            });
            assertThat(time.join(takingOff, PATIENCE).outcome()).isEqualTo(new Outcome.Succeeded());

            gapter.moveTo(gapter.port() + 2);
            await(() -> house.drone(1).link().key().port() == gapter.port(), () -> {
                gapter.beat(GAPTER);
                gapter.say(1, IN_THE_AIR);
            });
            assertThat(steer(drone, AHEAD)).isEmpty();
            assertThat(moving(gapter).path("vx").asDouble()).isEqualTo(0.4);
            assertThat(house.cloud().drones()).hasSize(1);
        }
    }

    /** A page of the bridges sends orders to this port as they are, and their hub hands them on to everybody. */
    @Test
    void ordersOfSomebodyElseReachNoRobotAndAreCounted() {
        try (SteppedRobot robot = robot(7, QUOTED_7);
                SteppedRobot page = robot(7, QUOTED_7);
                SteppedRobot hub = robot(8, QUOTED_8)) {
            hub.connect();
            hub.sayOnWeb(0, "\"type\":8");
            still(robot, 7);
            for (int id = 100; id < 110; id++) {
                page.say(id, "\"altitude\":1,\"vx\":1,\"vy\":0,\"vz\":0,\"wx\":0,\"wy\":0,\"wz\":0");
                hub.sayOnWeb(id, "\"vx\":1,\"vy\":0,\"vz\":0,\"wx\":0,\"wy\":0,\"wz\":0");
            }
            await(() -> proxy.unknownCount() == 20, () -> {});
            robot.say(2, "\"x\":5,\"y\":0," + STANDS);
            awaitDrone(7, drone -> drone.local() != null && drone.local().xMeters() == 5);
            time.advance(QUIET);

            assertThat(robot.told()).isEmpty();
            assertThat(house.cloud().drones()).hasSize(2);
        }
    }

    @Test
    void aTwistForOneOwnersRobotReachesNoOther() {
        try (SteppedRobot ours = robot(7, QUOTED_7);
                SteppedRobot theirs = robot(8, QUOTED_8)) {
            ours.connect();
            theirs.connect();
            still(ours, 7);
            still(theirs, 8);
            assertThat(steer(house.drone(7), AHEAD)).isEmpty();
            moving(ours);
            asked(ours, 100);
            time.advance(QUIET);

            assertThat(theirs.told()).isEmpty();
        }
    }

    /** It repeats each 51 ms what it heard last. */
    @Test
    void aRobotIsToldToStandAfterTheLastWordOfWhoSteersIt() {
        try (SteppedRobot robot = robot(7, QUOTED_7)) {
            still(robot, 7);
            assertThat(steer(house.drone(7), AHEAD)).isEmpty();
            moving(robot);
            JsonNode next = asked(robot, 100);

            assertThat(next.path("vx").asDouble(1)).isZero();
        }
    }
}
