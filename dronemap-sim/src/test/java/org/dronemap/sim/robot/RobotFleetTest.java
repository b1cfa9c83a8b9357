package org.dronemap.sim.robot;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.SocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.EnumSet;
import java.util.Objects;
import java.util.Set;
import java.util.function.Predicate;
import org.dronemap.sim.link.ServerAddress;
import org.dronemap.sim.robot.RobotOptions.Identity;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Simulated robots on a real socket, told by hand. */
class RobotFleetTest {
    private static final int PATIENCE_MILLIS = 15_000;

    private DatagramSocket server;
    private @Nullable SimulatedRobotFleet fleet;
    private @Nullable SocketAddress robot;

    @BeforeEach
    void listen() throws IOException {
        server = new DatagramSocket(0, InetAddress.getLoopbackAddress());
        server.setSoTimeout(PATIENCE_MILLIS);
    }

    @AfterEach
    void close() throws IOException {
        if (fleet != null) {
            fleet.close();
        }
        server.close();
    }

    private void start(String kind, Set<BridgeQuirk> quirks) throws IOException {
        ServerAddress address = new ServerAddress(false, "127.0.0.1", server.getLocalPort());
        fleet = new SimulatedRobotFleet(
                new RobotOptions(1, kind, address, null, new Identity(7, "12", "26"), 20, 0, quirks));
        fleet.start();
        heard(message -> true);
    }

    private SimulatedRobotFleet.GroundTruth truth() {
        return Objects.requireNonNull(fleet).truths().get(0);
    }

    private JsonNode heard(Predicate<JsonNode> wanted) throws IOException {
        long end = System.nanoTime() + PATIENCE_MILLIS * 1_000_000L;
        DatagramPacket packet = new DatagramPacket(new byte[65_535], 65_535);
        while (System.nanoTime() < end) {
            server.receive(packet);
            robot = packet.getSocketAddress();
            JsonNode message = JsonMapper.shared()
                    .readTree(new String(packet.getData(), 0, packet.getLength(), StandardCharsets.UTF_8));
            if (wanted.test(message)) {
                return message;
            }
        }
        throw new AssertionError("no such message came");
    }

    private JsonNode heard(int messageId) throws IOException {
        return heard(message -> message.path("header").path("message_id").asInt() == messageId);
    }

    private void tell(String key, int order, String body) throws IOException {
        String text = "{\"header\":{\"system_id\":7,\"message_id\":" + order + ",\"key\":" + key + "}" + body + "}";
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        server.send(new DatagramPacket(bytes, bytes.length, Objects.requireNonNull(robot)));
    }

    @Test
    void aRoverDrivesAsLongAsItIsToldTo() throws IOException {
        start("rover", Set.of());
        tell("\"12\"", RobotOrderIds.TWIST, ",\"vx\":0.4,\"wz\":0");
        heard(message -> message.path("vx").asDouble() > 0.3);
        heard(message -> message.path("vx").asDouble(1) == 0);

        assertThat(truth().x()).isBetween(-1.99, -1.5);
        assertThat(truth().speed()).isZero();
    }

    @Test
    void aBridgeThatRepeatsGoesOnUntilItIsToldZeros() throws IOException {
        start("rover", EnumSet.of(BridgeQuirk.REPEATS_TWIST, BridgeQuirk.NUMBER_KEY));
        tell("\"12\"", RobotOrderIds.TWIST, ",\"vx\":0.4,\"wz\":0");
        tell("12", RobotOrderIds.TWIST, ",\"vx\":-0.5,\"wz\":0");
        heard(message -> message.path("x").asDouble(0) < -2.8);
        assertThat(truth().speed()).isGreaterThan(0);
        tell("12", RobotOrderIds.TWIST, ",\"vx\":0,\"wz\":0");
        heard(message -> message.path("vx").asDouble(1) == 0);
        assertThat(truth().speed()).isZero();
    }

    @Test
    void aRoverGoesWhereItIsToldAndStopsWhenStopped() throws IOException {
        start("rover", Set.of(BridgeQuirk.DIES_OF_STOP));
        tell("\"12\"", RobotOrderIds.GO_TO, ",\"x\":-1,\"y\":-1,\"z\":0,\"frame_type\":\"false\"");
        heard(message ->
                Math.hypot(message.path("x").asDouble(9) + 1, message.path("y").asDouble(9) + 1) < 0.1);
        tell("\"12\"", RobotOrderIds.GO_TO, ",\"x\":0,\"y\":-1,\"z\":0");
        heard(message -> message.path("vx").asDouble() > 0.1);
        tell("\"12\"", RobotOrderIds.STOP, "");
        heard(message -> message.path("vx").asDouble(1) == 0);
        tell("\"12\"", RobotOrderIds.TWIST, ",\"vx\":0.4,\"wz\":0");
        tell("\"12\"", RobotOrderIds.TWIST, ",\"vx\":0.4,\"wz\":0");
        heard(2);
        heard(2);
        assertThat(truth().speed()).isZero();
    }

    @Test
    void showsScanPictureAndMapAndSpeaksAsItsBridgeDoes() throws IOException {
        start(
                "rover",
                EnumSet.of(BridgeQuirk.STATUS_IS_HEARTBEAT, BridgeQuirk.COUNTS_EACH_KIND, BridgeQuirk.BROKEN_LINES));
        JsonNode scan = heard(4);
        assertThat(scan.path("ranges")).hasSize(180);
        assertThat(scan.path("header").path("owner_id").isNumber()).isTrue();
        assertThat(heard(5).path("data").asString()).contains("\r\n");
        assertThat(heard(1).path("type").asInt()).isEqualTo(8);
        int before = heard(4).path("header").path("sequence_number").asInt();
        assertThat(heard(4).path("header").path("sequence_number").asInt()).isEqualTo(before + 1);

        tell("\"12\"", RobotOrderIds.GET_MAP, "");
        assertThat(heard(6).path("xoffset").asDouble()).isEqualTo(-4);
    }

    @Test
    void aDroneTakesOffInGuidedOnly() throws IOException {
        start("drone", Set.of());
        tell("\"12\"", RobotOrderIds.ARM, "");
        tell("\"12\"", RobotOrderIds.TAKE_OFF, ",\"altitude\":2");
        heard(message -> message.path("state").asInt() == 3_100);
        tell("\"12\"", RobotOrderIds.SET_MODE, ",\"flightMode\":4");
        tell("\"12\"", RobotOrderIds.TAKE_OFF, ",\"altitude\":2");
        heard(message -> message.path("z").asDouble() > 1.9);
        assertThat(truth().height()).isGreaterThan(1.9);
    }
}
