package org.dronemap.proxy.roslink;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.Arrays;
import java.util.Base64;
import java.util.Objects;
import java.util.concurrent.CompletableFuture;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.LocalPosition;
import org.dronemap.core.drone.SensorSnapshot;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;

/** The public bridges as they behave on their links, one after the other, each with what is odd about it. */
class PublicBridgeLinksTest extends RobotTestBase {
    private static final String STANDS = "\"vx\":0,\"vy\":0,\"vz\":0,\"wz\":0";

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
                        && house.drone(12).link().others().size() == 1;
            });
            assertThat(proxy.refusedCount()).isZero();
            assertThat(proxy.brokenCount()).isZero();
            assertThat(house.drone(12).battery()).isNull();
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
                        && house.drone(7).local() != null
                        && house.drone(7).link().transport().equals("websocket");
            });

            ria.disconnect();
            await(() -> {
                ria.say(0, "\"type\":12");
                return house.drone(7).link().transport().equals("udp");
            });
            assertThat(house.drone(7).local()).isEqualTo(new LocalPosition(1, 2, null, 0.0));
            assertThat(house.drone(7).battery()).isNull();
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
                            && house.drone(7).link().transport().equals("websocket")
                            && house.drone(7).link().state() == LinkState.LIVE;
                });
                robot.told();
                CompletableFuture<Outcome> holding = command(house.drone(7), new Command.Hold());
                asked(robot, 100);
                until(holding, () -> robot.sayOnWeb(2, "\"x\":0,\"y\":0," + STANDS));
                robot.disconnect();
                await(() -> {
                    robot.say(0, "\"type\":8");
                    return house.drone(7).link().transport().equals("udp");
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
    void largePicturesComeWholeOverBothLinksAndBrokenIntoLines() throws Exception {
        try (TestRobot robot = new TestRobot(udp(), 7, quoted())) {
            byte[] small = picture(45_000);
            await(() -> {
                robot.say(0, "\"type\":8");
                return !house.cloud().drones().isEmpty();
            });
            await(() -> {
                // A datagram of this size is easily lost where the machine is busy.
                robot.say(5, "\"height\":240,\"width\":320,\"data\":\"" + base64(small) + "\"");
                return isShown(small);
            });

            byte[] large = picture(150_000);
            robot.connect(web(), "/");
            robot.sayOnWeb(0, "\"type\":8");
            await(() -> {
                robot.say(0, "\"type\":8");
                robot.sayOnWeb(0, "\"type\":8");
                return house.drone(7).link().transport().equals("websocket");
            });
            String lines = Base64.getMimeEncoder().encodeToString(large).replace("\r\n", "\\n");
            assertThat(lines.length()).isGreaterThan(200_000);
            robot.sayOnWeb(5, "\"height\":240,\"width\":320,\"data\":\"" + lines + "\\n\"");
            shows(large);
        }
    }

    private void shows(byte[] picture) {
        await(() -> isShown(picture));
    }

    private boolean isShown(byte[] picture) {
        SensorSnapshot sensed = house.cloud().sensed(house.drone(7).id());
        return sensed.picture() != null
                && Arrays.equals(sensed.picture().value().bytes(), picture);
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
}
