package org.dronemap.proxy.roslink;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.Arrays;
import java.util.Base64;
import java.util.Objects;
import java.util.concurrent.CompletableFuture;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.Setpoint.Facing;
import org.dronemap.core.command.Setpoint.Frame;
import org.dronemap.core.command.Setpoint.Velocity;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LocalPosition;
import org.dronemap.core.drone.Sensed;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;

/** The public bridges as they behave on their links, one after the other, each with what is odd about it. */
class PublicBridgesTest extends RobotTrial {
    private static final int GAPTER = 2;
    private static final Velocity AHEAD = new Velocity(Frame.VEHICLE, 0.4, 0, 0, Facing.ANY);
    private static final String STANDS = "\"vx\":0,\"vy\":0,\"vz\":0,\"wz\":0";

    private static final String IN_THE_AIR = "\"state\":4104";

    @Test
    void theGapterOnUdpTakesItsOrdersOnThePortThatItSpeaksFrom() throws Exception {
        try (TestRobot gapter = new TestRobot(udp(), 1, "\"1243-0000-0000-FGFG\"")) {
            await(() -> {
                gapter.beat(GAPTER);
                gapter.say(1, "\"state\":3100");
                return house.cloud().drones().stream().anyMatch(drone -> Boolean.TRUE.equals(drone.armed()));
            });
            DroneState drone = drone(1);

            CompletableFuture<Outcome> takingOff = command(drone, new Command.TakeOff(1));
            assertThat(asked(gapter, 106).get("flightMode").intValue()).isEqualTo(4);
            gapter.say(1, "\"state\":3104");
            assertThat(asked(gapter, 102).get("altitude").doubleValue()).isEqualTo(1);
            until(takingOff, () -> {
                gapter.say(1, IN_THE_AIR);
                gapter.say(2, "\"x\":0,\"y\":0,\"z\":1," + STANDS);
            });

            gapter.moveTo("127.0.0.1");
            await(() -> {
                gapter.beat(GAPTER);
                gapter.say(1, IN_THE_AIR);
                return drone(1).link().key().port() == gapter.port();
            });
            assertThat(steer(drone, AHEAD)).isEmpty();
            assertThat(moving(gapter).path("vx").asDouble()).isEqualTo(0.4);
            assertThat(house.cloud().drones()).hasSize(1);
        }
    }

    /** Its key is a number in its header and a text in its path; a status of it is a heartbeat. */
    @Test
    void theTurtleBotIsOneRobotOnItsKeyedPathAndOverUdpWhateverItsWordsAreWrittenAs() throws Exception {
        try (TestRobot noetic = new TestRobot(udp(), 12, "12")) {
            noetic.connect(web(), "/websockets/roslink/user/12/robot/12/robot");
            await(() -> {
                noetic.sayOnWeb(0, "\"type\":8,\"owner_id\":\"26\"");
                noetic.sayOnWeb(1, "\"type\":8,\"name\":\"tb3\",\"system_status\":2,\"owner_id\":26,\"mode\":0");
                noetic.say(0, "\"type\":8");
                return house.cloud().drones().size() == 1
                        && drone(12).link().others().size() == 1;
            });
            assertThat(proxy.refusedCount()).isZero();
            assertThat(proxy.brokenCount()).isZero();
            assertThat(drone(12).battery()).isNull();
        }
    }

    /** While its WebSocket is there it says by UDP how it stands and moves, and else only that it is there. */
    @Test
    void theRiaE100IsHeardOnBothLinksAndStaysThereWhenItsConnectionEnds() throws Exception {
        try (TestRobot ria = new TestRobot(udp(), 7, quoted())) {
            ria.connect(web(), "/");
            await(() -> {
                ria.sayOnWeb(0, "\"type\":12");
                ria.say(0, "\"type\":12");
                ria.say(1, "\"type\":12,\"system_status\":2");
                ria.say(2, "\"x\":1,\"y\":2,\"z\":0," + STANDS);
                return house.cloud().drones().size() == 1
                        && drone(7).local() != null
                        && drone(7).link().transport().equals("websocket");
            });

            ria.disconnect();
            await(() -> {
                ria.say(0, "\"type\":12");
                return drone(7).link().transport().equals("udp");
            });
            assertThat(drone(7).local()).isEqualTo(new LocalPosition(1, 2, null, 0.0));
            assertThat(drone(7).battery()).isNull();
        }
    }

    /** It tries again a second later, and a second more each time: nobody holds its place against it. */
    @Test
    void aBridgeThatConnectsAgainIsTheSameRobotAtOnce() throws Exception {
        try (TestRobot robot = new TestRobot(udp(), 7, quoted())) {
            for (int times = 0; times < 3; times++) {
                robot.connect(web(), "/");
                await(() -> {
                    robot.sayOnWeb(0, "\"type\":8");
                    return house.cloud().drones().size() == 1
                            && drone(7).link().transport().equals("websocket");
                });
                robot.told();
                CompletableFuture<Outcome> holding = command(drone(7), new Command.Hold());
                asked(robot, 100);
                until(holding, () -> robot.sayOnWeb(2, "\"x\":0,\"y\":0," + STANDS));
                robot.disconnect();
                await(() -> {
                    robot.say(0, "\"type\":8");
                    return drone(7).link().transport().equals("udp");
                });
            }
            assertThat(proxy.refusedCount()).isZero();
        }
    }

    @Test
    void aPingIsAnswered() {
        try (TestRobot robot = new TestRobot(udp(), 7, quoted())) {
            robot.connect(web(), "/");
            robot.ping();
            await(() -> robot.pongs() == 1);
            robot.ping();
            await(() -> robot.pongs() == 2);
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    /** A page of the bridges sends orders to this port as they are, and their hub hands them on to everybody. */
    @Test
    void ordersOfSomebodyElseReachNoRobotAndAreCounted() throws Exception {
        try (TestRobot robot = new TestRobot(udp(), 7, quoted());
                TestRobot page = new TestRobot(udp(), 7, quoted());
                TestRobot hub = new TestRobot(udp(), 8, "\"" + SECRET_OF_8 + "\"")) {
            hub.connect(web(), "/");
            hub.sayOnWeb(0, "\"type\":8");
            still(robot);
            for (int id = 100; id < 110; id++) {
                page.say(id, "\"altitude\":1,\"vx\":1,\"vy\":0,\"vz\":0,\"wx\":0,\"wy\":0,\"wz\":0");
                hub.sayOnWeb(id, "\"vx\":1,\"vy\":0,\"vz\":0,\"wx\":0,\"wy\":0,\"wz\":0");
            }
            await(() -> proxy.unknownCount() == 20);
            robot.say(2, "\"x\":5,\"y\":0," + STANDS);
            awaitDrone(7, drone -> drone.local() != null && drone.local().xMeters() == 5);

            assertThat(robot.told()).isEmpty();
            assertThat(house.cloud().drones()).hasSize(2);
        }
    }

    /** One bridge stops taking orders at the first. */
    @Test
    void nothingThatARobotSaysIsEverAcknowledged() throws Exception {
        try (TestRobot robot = new TestRobot(udp(), 7, quoted())) {
            robot.connect(web(), "/");
            await(() -> {
                for (int id = 0; id < 8; id++) {
                    String body = "\"type\":8,\"data\":\"/9j/4AEC\",\"message_id\":" + id + "," + STANDS;
                    robot.say(id, body);
                    robot.sayOnWeb(id, body);
                }
                robot.sayOnWeb(109, "\"message_id\":100,\"sequence_number\":1");
                return proxy.unknownCount() > 20;
            });
            assertThat(robot.told())
                    .isNotEmpty()
                    .allSatisfy(order -> assertThat(
                                    order.get("header").get("message_id").intValue())
                            .isEqualTo(100));
        }
    }

    @Test
    void aTwistForOneOwnersRobotReachesNoOther() throws Exception {
        try (TestRobot ours = new TestRobot(udp(), 7, quoted());
                TestRobot theirs = new TestRobot(udp(), 8, "\"" + SECRET_OF_8 + "\"")) {
            ours.connect(web(), "/");
            theirs.connect(web(), "/");
            still(ours);
            still(theirs);
            assertThat(steer(drone(7), AHEAD)).isEmpty();
            moving(ours);
            asked(ours, 100);

            assertThat(theirs.told()).isEmpty();
        }
    }

    /** It repeats each 51 ms what it heard last. */
    @Test
    void aRobotIsToldToStandAfterTheLastWordOfWhoSteersIt() throws Exception {
        try (TestRobot robot = new TestRobot(udp(), 7, quoted())) {
            still(robot);
            assertThat(steer(drone(7), AHEAD)).isEmpty();
            moving(robot);
            JsonNode next = Objects.requireNonNull(robot.order(100, 5_000));

            assertThat(next.path("vx").asDouble(1)).isZero();
        }
    }

    @Test
    void largePicturesComeWholeOverBothLinksAndBrokenIntoLines() throws Exception {
        try (TestRobot robot = new TestRobot(udp(), 7, quoted())) {
            byte[] small = picture(45_000);
            await(() -> {
                robot.say(0, "\"type\":8");
                return !house.cloud().drones().isEmpty();
            });
            robot.say(5, "\"height\":240,\"width\":320,\"data\":\"" + base64(small) + "\"");
            shows(small);

            byte[] large = picture(150_000);
            robot.connect(web(), "/");
            robot.sayOnWeb(0, "\"type\":8");
            await(() -> {
                robot.say(0, "\"type\":8");
                robot.sayOnWeb(0, "\"type\":8");
                return drone(7).link().transport().equals("websocket");
            });
            String lines = Base64.getMimeEncoder().encodeToString(large).replace("\r\n", "\\n");
            assertThat(lines.length()).isGreaterThan(200_000);
            robot.sayOnWeb(5, "\"height\":240,\"width\":320,\"data\":\"" + lines + "\\n\"");
            shows(large);
        }
    }

    private void shows(byte[] picture) {
        await(() -> {
            Sensed sensed = house.cloud().sensed(drone(7).id());
            return sensed.picture() != null
                    && Arrays.equals(sensed.picture().value().bytes(), picture);
        });
    }

    private static byte[] picture(int bytes) {
        byte[] picture = new byte[bytes];
        new java.util.Random(bytes).nextBytes(picture);
        System.arraycopy(new byte[] {(byte) 0xff, (byte) 0xd8, (byte) 0xff, (byte) 0xe0}, 0, picture, 0, 4);
        return picture;
    }

    private static String base64(byte[] bytes) {
        return Base64.getEncoder().encodeToString(bytes);
    }

    private static String quoted() {
        return "\"" + SECRET_OF_7 + "\"";
    }

    private interface Step {
        void take() throws IOException;
    }

    /** Goes on reporting until the command is over, and it has succeeded. */
    private void until(CompletableFuture<Outcome> outcome, Step report) throws Exception {
        await(() -> {
            report.take();
            return outcome.isDone();
        });
        assertThat(outcome.get()).isEqualTo(new Outcome.Succeeded());
    }

    private static JsonNode asked(TestRobot robot, int order) throws InterruptedException {
        return Objects.requireNonNull(robot.order(order, 5_000));
    }

    /** It is there, stands, and is told nothing any more. */
    private void still(TestRobot robot) {
        await(() -> {
            robot.say(0, "\"type\":8");
            robot.say(2, "\"x\":0,\"y\":0," + STANDS);
            return house.cloud().drones().stream().anyMatch(drone -> drone.local() != null)
                    && robot.order(100, 700) == null;
        });
    }
}
