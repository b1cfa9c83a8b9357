package org.dronemap.proxy.roslink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.command.Setpoint.Facing;
import org.dronemap.core.command.Setpoint.Frame;
import org.dronemap.core.command.Setpoint.Velocity;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.recording.Recording;
import org.dronemap.core.recording.RecordingPolicy;
import org.dronemap.core.time.RealTime;
import org.dronemap.proxy.record.Recorder;
import org.dronemap.proxy.record.TestRecordingStore;
import org.dronemap.proxy.record.TextMessageTap;
import org.dronemap.proxy.roslink.wire.StringOrNumber;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What went over the wire of robots is kept, but no key, over real sockets. */
class RecordedRobotTest extends RobotTestBase {
    private static final Velocity AHEAD = new Velocity(Frame.VEHICLE, 0.4, 0, 0, new Facing.Turning(0));

    @TempDir
    Path directory;

    private final StoreWriter journal = new StoreWriter(new RealTime());
    private @Nullable Recorder recorder;

    @BeforeEach
    void record() throws Exception {
        Recorder made = new Recorder(
                directory,
                RecordingPolicy.DEFAULT,
                new Recorder.Dependencies(new TestRecordingStore(), journal, drone -> "Burger"),
                new RealTime());
        made.start();
        recorder = made;
    }

    @AfterEach
    void end() {
        shelf();
        recorder.close();
        journal.close();
    }

    @Override
    TextMessageTap tap() {
        return recorder == null ? TextMessageTap.NONE : recorder.openLines();
    }

    @Test
    void aDriveIsKeptBothWaysWithoutTheKey() throws Exception {
        try (TestRobot robot = new TestRobot(udp(), 7, '"' + SECRET_OF_7 + '"')) {
            robot.say(0, "\"type\":" + TURTLEBOT + ",\"owner_id\":12");
            DroneState drone = awaitDrone(7, state -> state.capabilities().known());
            await(() -> {
                robot.say(2, "\"x\":0,\"y\":0,\"vx\":0,\"vy\":0,\"wz\":0,\"name\":\"" + SECRET_OF_7 + "\"");
                return house.drone(7).local() != null;
            });
            assertThat(shelf()).isEmpty();
            assertThat(steer(drone, AHEAD)).isEmpty();
            moving(robot);
            robot.say(2, "\"x\":0.25,\"y\":0,\"vx\":0.4,\"vy\":0,\"wz\":0");
            robot.say(
                    2,
                    "\"x\":0.3,\"y\":0,\"vx\":0.4,\"vy\":0,\"padding\":\"" + "A".repeat(RobotRecordingTap.LONGEST_BYTES)
                            + "\"");
            await(() -> text().contains("\"bytes\":") && text().contains("0.25"));

            List<String> lines = text().lines().toList();
            assertThat(lines).allMatch(line -> line.startsWith("{\"at\":") && line.endsWith("}"));
            assertThat(lines).anyMatch(line -> line.contains("\"up\":false") && line.contains("\\\"vx\\\":0.4"));
            assertThat(lines).anyMatch(line -> line.contains("\"up\":true") && line.contains("\\\"x\\\":0.25"));
            assertThat(lines).as("what came before it was steered").anyMatch(line -> line.contains("\\\"x\\\":0,"));
            assertThat(lines).anyMatch(line -> line.contains("\"text\":null,\"bytes\":"));
            assertThat(text()).doesNotContain(SECRET_OF_7).contains("\\\"key\\\":\\\"***\\\"");
        }
    }

    @Test
    void noWayOfWritingAKeyIsKept() {
        StringOrNumber key = new StringOrNumber("geheimnis", false);
        assertThat(RobotRecordingTap.blanked("{\"key\" : \"geh\\\"x\",\"key\":12,\"a\":\"geheimnis\"}", key))
                .isEqualTo("{\"key\" : \"***\",\"key\":\"***\",\"a\":\"***\"}");
        assertThat(RobotRecordingTap.blanked("{\"k\\u0065y\":\"geheimnis\"}", key))
                .isNull();
        assertThat(RobotRecordingTap.blanked("{\"a\":\"\\u0067eheimnis\"}", key))
                .isNull();
    }

    private List<Recording> shelf() {
        Recorder made = recorder;
        return made == null ? List.of() : made.archive().recordings();
    }

    private String text() throws java.io.IOException {
        List<Recording> all = shelf();
        Recorder made = recorder;
        if (all.isEmpty() || made == null) {
            return "";
        }
        Path file = made.archive().file(all.get(0).id()).orElseThrow();
        assertThat(file.toString()).endsWith(".jsonl");
        return Files.readString(file);
    }
}
