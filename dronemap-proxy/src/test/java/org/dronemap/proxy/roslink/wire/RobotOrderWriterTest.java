package org.dronemap.proxy.roslink.wire;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

class RobotOrderWriterTest {
    private static final RoslinkHeader BRIDGE = new RoslinkHeader(
            PacketLayout.NESTED_HEADER,
            7,
            0,
            9L,
            new StringOrNumber("12", true),
            new StringOrNumber("maram", false),
            1,
            8);
    private static final RoslinkHeader PAPER =
            new RoslinkHeader(PacketLayout.PAYLOAD, 7, 0, null, new StringOrNumber("abc", false), null, 2, 0);

    private final RobotOrderWriter writer = new RobotOrderWriter();

    @Test
    void writesATakeOffAsTheBrowserOfTheBridgesDoes() {
        JsonNode order = written(BRIDGE, new RobotOrder.TakeOff(1.5));

        JsonNode header = order.get("header");
        assertThat(header.get("message_id").intValue()).isEqualTo(102);
        assertThat(header.get("system_id").intValue()).isEqualTo(7);
        assertThat(header.get("roslink_version").intValue()).isEqualTo(1);
        assertThat(header.get("ros_version").intValue()).isEqualTo(8);
        assertThat(header.get("sequence_number").intValue()).isEqualTo(1);
        assertThat(order.get("altitude").doubleValue()).isEqualTo(1.5);
    }

    @Test
    void givesKeyAndOwnerBackInTheTypeInWhichTheRobotSaysThem() {
        JsonNode header = written(BRIDGE, new RobotOrder.Land()).get("header");

        assertThat(header.get("key").isNumber()).isTrue();
        assertThat(header.get("key").intValue()).isEqualTo(12);
        assertThat(header.get("owner_id").isString()).isTrue();
    }

    @Test
    void answersARobotOfThePapersInItsOwnShape() {
        JsonNode order = written(PAPER, new RobotOrder.SetMode(4));

        assertThat(order.has("header")).isFalse();
        assertThat(order.get("message_id").intValue()).isEqualTo(106);
        assertThat(order.has("owner_id")).isFalse();
        assertThat(order.get("payload").get("flightMode").isInt()).isTrue();
        assertThat(order.get("payload").get("flightMode").intValue()).isEqualTo(4);
    }

    @Test
    void alwaysWritesAllSixSpeedsOfATwist() {
        JsonNode order = written(BRIDGE, RobotOrder.Twist.STOP);

        assertThat(order.get("header").get("message_id").intValue()).isEqualTo(100);
        for (String axis : new String[] {"vx", "vy", "vz", "wx", "wy", "wz"}) {
            assertThat(order.get(axis).doubleValue()).as(axis).isZero();
        }
    }

    @Test
    void namesTheFrameOfAGoToByAWord() {
        assertThat(written(BRIDGE, new RobotOrder.GoTo(1, 2, 0, false))
                        .get("frame_type")
                        .stringValue())
                .isEqualTo("false");
        assertThat(written(BRIDGE, new RobotOrder.GoTo(1, 2, 0, true))
                        .get("frame_type")
                        .stringValue())
                .isEqualTo("true");
    }

    @Test
    void numbersOrdersInOneRowAndEachByItsId() {
        RobotOrder[] orders = {
            new RobotOrder.Land(),
            new RobotOrder.Arm(),
            new RobotOrder.Disarm(),
            new RobotOrder.GetMap(),
            new RobotOrder.EmergencyStop()
        };
        int[] ids = {103, 104, 105, 107, 108};
        for (int i = 0; i < orders.length; i++) {
            JsonNode header = written(BRIDGE, orders[i]).get("header");
            assertThat(header.get("message_id").intValue()).isEqualTo(ids[i]);
            assertThat(header.get("sequence_number").intValue()).isEqualTo(i + 1);
        }
    }

    private JsonNode written(RoslinkHeader robot, RobotOrder order) {
        return JsonMapper.shared().readTree(new String(writer.write(robot, order), StandardCharsets.UTF_8));
    }
}
