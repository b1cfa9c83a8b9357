package org.dronemap.proxy.roslink.wire;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import org.dronemap.proxy.roslink.wire.PacketReadResult.Fault;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Packets as public bridges and the protocol's papers lay them out, with the oddities of each. */
class RoslinkPacketReaderTest {
    private static final String HEADER =
            "\"header\":{\"roslink_version\":1,\"ros_version\":8,\"system_id\":7,\"message_id\":%d,"
                    + "\"sequence_number\":42,\"key\":\"1243-0000-0000-FGFG\",\"owner_id\":26}";

    private final RoslinkPacketReader reader = new RoslinkPacketReader();

    @Test
    void readsAHeartbeatWithItsHeaderInAnObject() {
        RoslinkPacket packet =
                good(nested(0, "\"type\":3,\"name\":\"gapter\",\"system_status\":2,\"owner_id\":26,\"mode\":0"));

        RoslinkHeader header = packet.header();
        assertThat(header.shape()).isEqualTo(PacketLayout.NESTED_HEADER);
        assertThat(header.systemId()).isEqualTo(7);
        assertThat(header.sequence()).isEqualTo(42);
        assertThat(header.key()).isEqualTo(new StringOrNumber("1243-0000-0000-FGFG", false));
        assertThat(header.owner()).isEqualTo(new StringOrNumber("26", true));
        assertThat(header.version()).isEqualTo(1);
        assertThat(header.rosVersion()).isEqualTo(8);
        assertThat(packet.message()).isEqualTo(new RobotMessage.Heartbeat(3, "gapter", 2, 0));
    }

    @Test
    void readsTheShapeOfThePapersWithTheBodyUnderPayload() {
        RoslinkPacket packet = good(
                "{\"roslink_version\":2,\"system_id\":300,\"message_id\":0,\"sequence_number\":5,"
                        + "\"payload\":{\"type\":8,\"name\":\"turtle\",\"system_status\":2,\"owner_id\":\"maram\",\"mode\":0}}");

        assertThat(packet.header().shape()).isEqualTo(PacketLayout.PAYLOAD);
        assertThat(packet.header().systemId()).isEqualTo(300);
        assertThat(packet.header().owner()).isEqualTo(new StringOrNumber("maram", false));
        assertThat(packet.header().key()).isNull();
        assertThat(packet.message()).isEqualTo(new RobotMessage.Heartbeat(8, "turtle", 2, 0));
    }

    @Test
    void takesTheYawOfThePapersForTheHeading() {
        RoslinkPacket packet =
                good("{\"system_id\":1,\"message_id\":2,\"payload\":{\"x\":1.5,\"y\":-2,\"z\":0,\"yaw\":0.5}}");

        RobotMessage.Motion motion = (RobotMessage.Motion) packet.message();
        assertThat(motion.angles().heading()).isEqualTo(0.5);
        assertThat(motion.place()).isEqualTo(new RobotMessage.Triple(1.5, -2.0, 0.0));
        assertThat(motion.speed().x()).isNull();
    }

    @Test
    void readsTheStatusOfADrone() {
        RoslinkPacket packet = good(nested(
                1,
                "\"state\":4104,\"onboard_control_sensors_present\":[],\"onboard_control_sensors_enabled\":[],"
                        + "\"voltage_battery\":12.4,\"current_battery\":3,\"battery_remaining\":80"));

        assertThat(packet.message()).isEqualTo(new RobotMessage.Status(4104, 12.4, 3.0, 80.0));
    }

    @Test
    void takesAStatusWithTheBodyOfAHeartbeatForAHeartbeat() {
        RoslinkPacket packet =
                good(nested(1, "\"type\":8,\"name\":\"tb3\",\"system_status\":2,\"owner_id\":12,\"mode\":0"));

        assertThat(packet.message()).isEqualTo(new RobotMessage.Heartbeat(8, "tb3", 2, 0));
    }

    @Test
    void readsDegreesAsDegreesAndWhatIsNotFilledAsUnknown() {
        RoslinkPacket packet =
                good(nested(3, "\"fix_type\":3,\"lat\":24.7136,\"lon\":46.6753,\"satellites_visible\":9"));

        assertThat(packet.message()).isEqualTo(new RobotMessage.Satellites(3, 24.7136, 46.6753, null, 9));
    }

    @Test
    void readsAScanWithRangesThatWereNotMeasured() {
        RoslinkPacket packet = good(nested(
                4,
                "\"angle_min\":-1.5,\"angle_increment\":0.1,\"range_max\":3.5,\"ranges\":[1.0,Infinity,NaN,null,2]"));

        RobotMessage.Scan scan = (RobotMessage.Scan) packet.message();
        assertThat(scan.ranges()).containsExactly(1.0, null, null, null, 2.0);
        assertThat(scan.rangeMin()).isNull();
        assertThat(scan.rangeMax()).isEqualTo(3.5);
    }

    @Test
    void readsAnImageOfTwoHundredKilobytesWithLineBreaks() {
        byte[] picture = new byte[150_000];
        new java.util.Random(1).nextBytes(picture);
        String broken = Base64.getMimeEncoder().encodeToString(picture).replace("\r\n", "\\n");

        RoslinkPacket packet = good(
                nested(5, "\"owner_id\":1,\"key\":\"k\",\"height\":240,\"width\":320,\"data\":\"" + broken + "\\n\""));

        RobotMessage.Image image = (RobotMessage.Image) packet.message();
        assertThat(Base64Text.decode(image.base64()))
                .hasValueSatisfying(bytes -> assertThat(bytes).isEqualTo(picture));
        assertThat(image.view()).isNull();
    }

    @Test
    void readsFromWhereAPlacedImageWasTaken() {
        RoslinkPacket packet =
                good(nested(7, "\"data\":\"AAAA\",\"lat\":24.5,\"lon\":46.5,\"alt\":30,\"camera_yaw\":1"));

        assertThat(packet.message()).isEqualTo(new RobotMessage.Image("AAAA", new RobotMessage.View(24.5, 46.5, 30.0)));
    }

    @Test
    void readsAMapWhoseLastFieldsAreNull() {
        RoslinkPacket packet = good(nested(
                6,
                "\"data\":\"AAAA\",\"height\":20,\"width\":20,\"xoffset\":-10,\"yoffset\":-10,"
                        + "\"occupied_thresh\":null,\"free_thresh\":null,\"resolution\":null"));

        assertThat(packet.message()).isEqualTo(new RobotMessage.MapImage("AAAA", 20.0, 20.0, -10.0, -10.0, null));
    }

    @Test
    void takesAKeyThatIsANumberForTheSameWordAsItsText() {
        RoslinkPacket number = good("{\"header\":{\"system_id\":1,\"message_id\":0,\"key\":12,\"owner_id\":\"26\"}}");
        RoslinkPacket text = good("{\"header\":{\"system_id\":1,\"message_id\":0,\"key\":\"12\",\"owner_id\":26}}");

        assertThat(number.header().key()).isEqualTo(new StringOrNumber("12", true));
        assertThat(text.header().key()).isEqualTo(new StringOrNumber("12", false));
        assertThat(number.header().owner().text())
                .isEqualTo(text.header().owner().text());
    }

    @Test
    void needsNeitherOwnerNorKeyNorSequenceNorVersions() {
        RoslinkPacket packet = good("{\"header\":{\"system_id\":1,\"message_id\":0}}");

        assertThat(packet.header())
                .isEqualTo(new RoslinkHeader(PacketLayout.NESTED_HEADER, 1, 0, null, null, null, 1, 0));
        assertThat(packet.message()).isEqualTo(new RobotMessage.Heartbeat(null, null, null, null));
    }

    @Test
    void takesNumbersInStringsAndWithAFractionOfNothing() {
        RoslinkPacket packet =
                good("{\"header\":{\"system_id\":\"3\",\"message_id\":2.0},\"x\":\" 1.25 \",\"y\":\"north\"}");

        RobotMessage.Motion motion = (RobotMessage.Motion) packet.message();
        assertThat(packet.header().systemId()).isEqualTo(3);
        assertThat(motion.place()).isEqualTo(new RobotMessage.Triple(1.25, null, null));
    }

    @Test
    void takesAFieldOfAnotherTypeForOneThatIsNotThere() {
        RoslinkPacket packet =
                good(nested(2, "\"x\":[1],\"y\":{\"z\":1},\"z\":true,\"vx\":1e999,\"vy\":" + "9".repeat(60)));

        RobotMessage.Motion motion = (RobotMessage.Motion) packet.message();
        assertThat(motion.place()).isEqualTo(new RobotMessage.Triple(null, null, null));
        assertThat(motion.speed().x()).isNull();
        assertThat(motion.speed().y()).isEqualTo(1e60);
    }

    @Test
    void knowsNothingOfOtherMessagesButWhoSendsThem() {
        assertThat(good(nested(109, "\"message_id\":102")).message()).isEqualTo(new RobotMessage.Unknown());
        assertThat(good(nested(4711, "\"x\":1")).header().messageId()).isEqualTo(4711);
    }

    @Test
    void neverShowsTheKeyInALog() {
        assertThat(good(nested(0, "\"type\":3")).header().toString())
                .doesNotContain("1243")
                .contains("system 7");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                " ",
                "null",
                "[]",
                "42",
                "\"text\"",
                "{",
                "{\"header\":",
                "{'header':{}}",
                "{\"header\":{\"system_id\":1,\"message_id\":0}}{\"header\":{\"system_id\":1,\"message_id\":0}}",
                "{\"header\":{\"system_id\":1,\"message_id\":0}} and more",
                "\u0000\u0001\u0002"
            })
    void saysThatSomethingElseIsNoJsonObject(String text) {
        assertThat(read(text)).isEqualTo(new PacketReadResult.Bad(Fault.NO_JSON));
    }

    @Test
    void readsAMessageWhoseNameIsInAnotherEncoding() {
        byte[] bytes = nested(0, "\"name\":\"Andr?\",\"type\":8").getBytes(StandardCharsets.UTF_8);
        bytes[new String(bytes, StandardCharsets.UTF_8).indexOf('?')] = (byte) 0xE9;

        assertThat(reader.read(ByteBuffer.wrap(bytes)))
                .isInstanceOfSatisfying(
                        PacketReadResult.Good.class,
                        good -> assertThat(good.packet().message())
                                .isEqualTo(new RobotMessage.Heartbeat(8, "Andr\uFFFD", null, null)));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "{}",
                "{\"header\":{}}",
                "{\"header\":{\"system_id\":1}}",
                "{\"header\":{\"message_id\":1}}",
                "{\"header\":{\"system_id\":-1,\"message_id\":0}}",
                "{\"header\":{\"system_id\":65536,\"message_id\":0}}",
                "{\"header\":{\"system_id\":1.5,\"message_id\":0}}",
                "{\"header\":{\"system_id\":NaN,\"message_id\":0}}",
                "{\"header\":{\"system_id\":1,\"message_id\":99999999999999999999}}",
                "{\"header\":{\"system_id\":null,\"message_id\":0},\"system_id\":1}"
            })
    void saysThatAMessageNeedsASystemAndAKind(String text) {
        assertThat(read(text)).isEqualTo(new PacketReadResult.Bad(Fault.NO_HEADER));
    }

    @Test
    void refusesAnImageWithoutData() {
        assertThat(read("{" + HEADER.formatted(5) + ",\"height\":1}"))
                .isEqualTo(new PacketReadResult.Bad(Fault.WITHOUT_DATA));
    }

    @Test
    void refusesWhatIsTooDeepTooLongOrOfTooManyParts() {
        String start = "{" + HEADER.formatted(2) + ",\"x\":";
        assertThat(read(start + "[".repeat(5_000) + "]".repeat(5_000) + "}"))
                .isEqualTo(new PacketReadResult.Bad(Fault.NO_JSON));
        assertThat(read(start + "[" + "1,".repeat(100_000) + "1]}")).isEqualTo(new PacketReadResult.Bad(Fault.NO_JSON));
        assertThat(read(start + "1" + "0".repeat(100_000) + "}")).isEqualTo(new PacketReadResult.Bad(Fault.NO_JSON));
        assertThat(read("{\"" + "n".repeat(10_000) + "\":1," + HEADER.formatted(2) + "}"))
                .isEqualTo(new PacketReadResult.Bad(Fault.NO_JSON));
        assertThat(read(start + "\"" + "a".repeat(RoslinkPacketReader.LONGEST_BYTES) + "\"}"))
                .isEqualTo(new PacketReadResult.Bad(Fault.TOO_LONG));
    }

    @Test
    void takesNoKeyAsLongAsAPageNorOneWithControlCharacters() {
        RoslinkPacket longOne =
                good("{\"header\":{\"system_id\":1,\"message_id\":0,\"key\":\"" + "k".repeat(65) + "\"}}");
        RoslinkPacket odd = good("{\"header\":{\"system_id\":1,\"message_id\":0,\"key\":\"a\\u0000b\"}}");

        assertThat(longOne.header().key()).isNull();
        assertThat(odd.header().key()).isNull();
    }

    private static String nested(int messageId, String body) {
        return "{" + HEADER.formatted(messageId) + "," + body + "}";
    }

    private PacketReadResult read(String text) {
        return reader.read(ByteBuffer.wrap(text.getBytes(StandardCharsets.UTF_8)));
    }

    private RoslinkPacket good(String text) {
        PacketReadResult reading = read(text);
        assertThat(reading).as(text).isInstanceOf(PacketReadResult.Good.class);
        return ((PacketReadResult.Good) reading).packet();
    }
}
