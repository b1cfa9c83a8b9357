package org.dronemap.proxy.roslink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.proxy.roslink.wire.PacketReadResult;
import org.dronemap.proxy.roslink.wire.RoslinkPacketReader;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Each bridge leaves out other fields: whatever is missing, no kind of robot's message may fail. */
class LenientPacketTest {
    private static final List<List<String>> BODIES = List.of(
            List.of("type", "name", "system_status", "owner_id", "mode"),
            List.of("state", "voltage_battery", "current_battery", "battery_remaining", "type"),
            List.of("x", "y", "z", "vx", "vy", "vz", "wz", "pitch", "roll", "heading"),
            List.of("fix_type", "lat", "lon", "alt", "eph", "vel", "cog", "satellites_visible"),
            List.of("angle_min", "angle_increment", "range_min", "range_max", "ranges"),
            List.of("data", "height", "width"),
            List.of("data", "height", "width", "xoffset", "yoffset", "resolution"),
            List.of("data", "lat", "lon", "alt"));

    private final RoslinkPacketReader reader = new RoslinkPacketReader();

    @ParameterizedTest
    @EnumSource(RobotType.class)
    void anyFieldsMayBeMissing(RobotType type) {
        assertThat(heard(type, "1")).isNotEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"0", "-1", "1e308", "null", "\"\"", "{}", "[null]"})
    void anyFieldsMayBeMissingWhateverTheOthersSay(String value) {
        assertThat(heard(RobotType.TURTLEBOT, value)).doesNotContainNull();
        assertThat(heard(RobotType.GAPTER, value)).doesNotContainNull();
    }

    /** What comes of every choice of fields of every message. */
    private List<DroneEvent> heard(RobotType type, String value) {
        List<DroneEvent> news = new ArrayList<>();
        RobotTelemetryTranslator telemetry = new RobotTelemetryTranslator(type, null, news::add, () -> {});
        for (int messageId = 0; messageId < BODIES.size(); messageId++) {
            for (int choice = 0; choice < 1 << BODIES.get(messageId).size(); choice++) {
                if (reader.read(message(messageId, choice, value)) instanceof PacketReadResult.Good good) {
                    telemetry.received(good.packet().message());
                }
            }
        }
        return news;
    }

    private static ByteBuffer message(int messageId, int choice, String value) {
        List<String> names = BODIES.get(messageId);
        String body = names.stream()
                .filter(name -> (choice >> names.indexOf(name) & 1) == 1)
                .map(name -> ",\"" + name + "\":" + filled(name, value))
                .collect(Collectors.joining());
        String text = "{\"header\":{\"system_id\":1,\"message_id\":" + messageId + "}" + body + "}";
        return ByteBuffer.wrap(text.getBytes(StandardCharsets.UTF_8));
    }

    private static String filled(String name, String value) {
        return switch (name) {
            case "data" -> "\"/9j/4AEC\"";
            case "ranges" -> "[" + value + ",2]";
            default -> value;
        };
    }
}
