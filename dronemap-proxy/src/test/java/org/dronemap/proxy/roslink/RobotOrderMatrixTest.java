package org.dronemap.proxy.roslink;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CommandGate;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.EmergencyStop;
import org.dronemap.core.command.GoToLocal;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.ReadMap;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.proxy.session.Enrolment;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.JsonNode;

/**
 * Every order, to robots on UDP and on both paths of WebSockets, beside robots of another owner and those who are not whom
 * they say: it reaches its own robot and nobody else.
 */
class RobotOrderMatrixTest extends RobotTestBase {
    private static final String KEYED = "keyed";
    private static final String STANDS = "\"x\":0,\"y\":0,\"z\":0,\"vx\":0,\"vy\":0,\"vz\":0,\"wz\":0";

    private final List<Participant> robots = new ArrayList<>();
    private final List<Participant> liars = new ArrayList<>();

    /** Somebody with a key, by one of the ways, who goes on saying what it last had to. */
    private final class Participant {
        private final TestRobot robot;
        private final boolean onWeb;
        private final int type;
        private String status = "\"state\":3004";
        private String motion = STANDS;
        private boolean mapped;

        Participant(int systemId, String key, int type, String way, String host) throws IOException {
            this.type = type;
            robot = new TestRobot(udp(), systemId, "\"" + key + "\"");
            robot.moveTo(host);
            onWeb = !way.equals("udp");
            if (onWeb) {
                robot.connect(web(), way.equals(KEYED) ? "/websockets/roslink/user/1/robot/" + key + "/robot" : way);
            }
        }

        void live() throws IOException {
            say(0, "\"type\":" + type);
            say(1, status);
            say(2, motion);
            if (mapped) {
                say(6, "\"data\":\"/9j/4AEC\"");
            }
        }

        private void say(int id, String body) throws IOException {
            if (onWeb) {
                robot.sayOnWeb(id, body);
            } else {
                robot.say(id, body);
            }
        }
    }

    @AfterEach
    void leave() {
        robots.forEach(party -> party.robot.close());
        liars.forEach(party -> party.robot.close());
    }

    @ParameterizedTest
    @ValueSource(strings = {"udp", "/", KEYED})
    void eachOrderReachesItsOwnRobotAlone(String way) throws Exception {
        proxy.close();
        proxy = open(Enrolment.NOWHERE);
        proxy.start();
        keys.issue("rk-of-nine", new DroneId("drobot0009"), 9, null);
        keys.issue("rk-of-ten", new DroneId("drobot0010"), 10, null);
        keys.issue("rk-of-seven", TestRobotKeys.ROBOT_7, 7, null);
        keys.issue("rk-of-eight", TestRobotKeys.ROBOT_8, 8, null);
        Participant rover = join(7, "rk-of-seven", TURTLEBOT, way);
        Participant flyer = join(9, "rk-of-nine", QUADROTOR, way);
        List<Participant> others =
                List.of(join(8, "rk-of-eight", TURTLEBOT, way), join(10, "rk-of-ten", QUADROTOR, way));
        lie(7, "rk-of-seven", "rk-of-eight");
        lie(9, "rk-of-nine", "rk-of-ten");

        drive(rover);
        fly(flyer);
        steer(rover);

        assertThat(others)
                .allSatisfy(other -> assertThat(other.robot.told())
                        .allSatisfy(order -> assertThat(isStop(order)).isTrue()));
        assertThat(liars)
                .hasSize(way.equals("udp") ? 20 : 24)
                .allSatisfy(liar -> assertThat(liar.robot.ordersWaiting() + liar.robot.heartbeats())
                        .isZero());
        assertThat(house.cloud().drones()).hasSize(4);
    }

    private void drive(Participant rover) throws Exception {
        obeys(rover, 7, new Command.Hold(), 100, () -> rover.motion = STANDS);
        obeys(
                rover,
                7,
                new GoToLocal(2, 1, null),
                101,
                () -> rover.motion = STANDS.replace("\"x\":0,\"y\":0", "\"x\":2,\"y\":1"));
        obeys(rover, 7, new ReadMap(), 107, () -> rover.mapped = true);
        obeys(rover, 7, new EmergencyStop(), 108, () -> rover.motion = STANDS);
    }

    /** The last, as whoever steers keeps control for a while. */
    private void steer(Participant rover) {
        assertThat(house.cloud()
                        .setpoints()
                        .steer(
                                new CommandGate.Source(new Principal("pilot", Role.OPERATOR), "rest"),
                                house.drone(7).id(),
                                new Setpoint.Velocity(Setpoint.Frame.VEHICLE, 0.4, 0, 0, Setpoint.Facing.ANY)))
                .isEmpty();
        await(() -> {
            live();
            return rover.robot.told().stream().anyMatch(order -> !isStop(order));
        });
    }

    private void fly(Participant flyer) throws Exception {
        obeys(flyer, 9, new Command.SetMode("LOITER"), 106, () -> flyer.status = "\"state\":3005");
        obeys(flyer, 9, new Command.SetMode("GUIDED"), 106, () -> flyer.status = "\"state\":3004");
        obeys(flyer, 9, new Command.Arm(), 104, () -> flyer.status = "\"state\":3104");
        obeys(flyer, 9, new Command.TakeOff(3), 102, () -> {
            flyer.status = "\"state\":4104";
            flyer.motion = STANDS.replace("\"z\":0", "\"z\":3");
        });
        obeys(flyer, 9, new Command.Land(), 103, () -> {
            flyer.status = "\"state\":3104";
            flyer.motion = STANDS;
        });
        obeys(flyer, 9, new Command.Disarm(false), 105, () -> flyer.status = "\"state\":3004");
    }

    /** It hears the order, does it, and is believed. */
    private void obeys(Participant party, int systemId, Command command, int order, Runnable act) throws Exception {
        CompletableFuture<Outcome> outcome = command(house.drone(systemId), command);
        await(() -> {
            live();
            return party.robot.order(order, 20) != null;
        });
        act.run();
        await(() -> {
            live();
            return outcome.isDone();
        });
        assertThat(outcome.get()).isEqualTo(new Outcome.Succeeded());
    }

    private Participant join(int systemId, String key, int type, String way) throws IOException {
        Participant party = new Participant(systemId, key, type, way, "127.0.0.1");
        robots.add(party);
        await(() -> {
            live();
            return house.cloud().drones().stream()
                    .anyMatch(drone -> drone.link().key().systemId() == systemId && drone.local() != null);
        });
        return party;
    }

    /** A void key, another robot's, a word of its own, and the right one from elsewhere, by each way: all are reported. */
    private void lie(int systemId, String key, String another) throws IOException {
        for (String way : List.of("udp", "/", KEYED)) {
            for (String shown : List.of("rk-of-nobody", another, "a word", key)) {
                boolean right = shown.equals(key);
                if (right && !way.equals("udp") && !robots.get(0).onWeb) {
                    // From the robot's own host this is its other link.
                    continue;
                }
                String host = right ? "127.0.0.2" : "127.0.0.1";
                Participant liar = new Participant(systemId, shown.replace(' ', '-'), TURTLEBOT, way, host);
                liars.add(liar);
                long before = proxy.refusedCount();
                await(() -> {
                    for (Participant robot : robots) {
                        robot.live();
                    }
                    liar.live();
                    return proxy.refusedCount() > before + 1;
                });
            }
        }
    }

    private void live() throws IOException {
        for (Participant robot : robots) {
            robot.live();
        }
        for (Participant liar : liars) {
            liar.live();
        }
    }

    private static boolean isStop(JsonNode order) {
        return order.get("header").get("message_id").intValue() == 100
                && List.of("vx", "vy", "vz", "wz").stream()
                        .allMatch(axis -> order.path(axis).asDouble(1) == 0);
    }
}
