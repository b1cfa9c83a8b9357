package org.dronemap.proxy.record;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.UUID;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CommandGate;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.TextMessage;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.time.SteppedTime;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.Statustext;
import org.dronemap.proxy.FakeVehicle;
import org.dronemap.proxy.TestCloud;
import org.dronemap.proxy.session.FrameTap;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;

class RecordingReplayTest {
    private static final long START_MICROS = 1_700_000_000_000_000L;

    private final SteppedTime time = new SteppedTime(Instant.parse("2026-03-04T05:06:07Z"));
    private final TestCloud cloud = new TestCloud(componentId -> FrameTap.NONE, time);
    private final ByteArrayOutputStream tlog = new ByteArrayOutputStream();
    private long micros = START_MICROS;

    @AfterEach
    void close() {
        cloud.close();
        assertThat(time.failures()).isEmpty();
    }

    private void record(int systemId, int componentId, Message message) {
        tlog.writeBytes(ByteBuffer.allocate(8).putLong(micros).array());
        tlog.writeBytes(new FrameWriter(systemId, componentId, 2).frame(message));
        micros += 100_000;
    }

    private RecordingReplay play(double speed) {
        return cloud.proxy()
                .replays()
                .start(new ReplayRegistry.Source(
                        "flight.tlog", new ByteArrayInputStream(tlog.toByteArray()), tlog.size(), speed));
    }

    private void recordTwoVehicles() {
        for (int second = 0; second < 10; second++) {
            record(1, 1, FakeVehicle.copter(5, true));
            record(1, 100, new Heartbeat(30, 8, 0, 0, 3, 3));
            record(255, 190, new Heartbeat(6, 8, 0, 0, 4, 3));
            record(2, 1, new Heartbeat(10, 3, 1, 4, 4, 3));
            record(1, 1, new GlobalPositionInt(0, 473977420, 85455940, 500_000, 12_000, 0, 0, 0, 0));
        }
    }

    private void awaitState(RecordingReplay replay, ReplayStatus.State state) {
        TestCloud.await(
                time,
                Duration.ofSeconds(60),
                () -> replay.status().state() == state,
                () -> replay.status().toString());
    }

    @Test
    void showsTheVehiclesOfARecordingMarkedAndBeyondCommand() {
        recordTwoVehicles();
        RecordingReplay replay = play(100);
        awaitState(replay, ReplayStatus.State.FINISHED);
        DroneState copter = cloud.awaitDrone(state -> state.position() != null);

        assertThat(replay.status().records()).isEqualTo(50);
        assertThat(replay.status().goodMessages()).isEqualTo(50);
        assertThat(replay.status().progress()).isEqualTo(1);
        assertThat(replay.status().drones()).hasSize(2);
        assertThat(cloud.cloud().drones()).hasSize(2).allMatch(DroneState::replay);
        assertThat(copter.mode()).isEqualTo("LOITER");
        assertThat(copter.link().transport()).isEqualTo("replay");
        assertThat(cloud.cloud()
                        .gate()
                        .submit(
                                new CommandGate.Source(new Principal("pilot", Role.OPERATOR), "rest"),
                                copter.id(),
                                new CommandId(UUID.randomUUID().toString()),
                                new Command.Land())
                        .outcome())
                .isEqualTo(new Outcome.Refused(
                        "gate", "This is a recording; it cannot be commanded.", OutcomeCode.DRONE_IS_A_RECORDING));
    }

    /** More at the same moment than a session has room for. */
    @Test
    void losesNoFrameThatThereIsNoRoomForAtOnce() {
        long moment = micros;
        for (int count = 0; count < 1_900; count++) {
            record(1, 1, FakeVehicle.copter(5, true));
            micros = moment;
        }
        record(1, 1, new Statustext(4, "the last of that moment", 0, 0));
        for (int second = 0; second < 10; second++) {
            record(1, 1, FakeVehicle.copter(5, true));
        }

        awaitState(play(1), ReplayStatus.State.FINISHED);

        assertThat(cloud.awaitDrone(DroneState::replay).messages())
                .extracting(TextMessage::text)
                .contains("the last of that moment");
    }

    @Test
    void callsItsVehiclesEndedAndNotLostWhenItIsOver() {
        recordTwoVehicles();
        awaitState(play(100), ReplayStatus.State.FINISHED);

        TestCloud.await(
                time,
                Duration.ofSeconds(10),
                () -> cloud.cloud().drones().stream()
                                .filter(drone -> drone.link().state() == LinkState.ENDED)
                                .count()
                        == 2,
                () -> cloud.cloud().drones().toString());
        assertThat(cloud.cloud().drones())
                .allSatisfy(drone -> assertThat(drone.messages())
                        .extracting(TextMessage::text)
                        .doesNotContain("Contact lost."));
    }

    @Test
    void takesItsDronesAwayWhenCancelled() {
        recordTwoVehicles();
        RecordingReplay replay = play(1);
        TestCloud.await(
                time, Duration.ofSeconds(10), () -> replay.status().drones().size() == 2, () -> "no drones");

        assertThat(cloud.proxy().replays().remove(replay.id())).isTrue();
        assertThat(replay.status().state())
                .as("whoever cancelled it reads so at once")
                .isEqualTo(ReplayStatus.State.CANCELLED);
        TestCloud.await(
                time, Duration.ofSeconds(5), () -> cloud.cloud().drones().isEmpty(), () -> "still there");
    }

    @Test
    void saysThatItCouldNotBeRead() {
        InputStream broken = new InputStream() {
            @Override
            public int read() throws IOException {
                throw new IOException("the disk is gone");
            }
        };
        RecordingReplay replay = cloud.proxy().replays().start(new ReplayRegistry.Source("x.tlog", broken, 10, 1));
        awaitState(replay, ReplayStatus.State.FAILED);

        assertThat(replay.status().failure()).isEqualTo("The recording could not be read: the disk is gone.");
    }

    @Test
    void saysThatThereIsNoMessageInAFileOfAnotherKind() {
        tlog.writeBytes("FMT, 128, 89, FMT, BBnNZ, Type,Length,Name,Format,Columns\n"
                .repeat(20)
                .getBytes(US_ASCII));
        RecordingReplay replay = play(10);
        awaitState(replay, ReplayStatus.State.FAILED);

        assertThat(replay.status().failure()).contains("not one message of MAVLink", "tlog");
    }

    @Test
    void refusesASpeedThatMakesNoSense() {
        assertThatThrownBy(() -> new ReplayRegistry.Source("x", InputStream.nullInputStream(), 0, 0))
                .hasMessage("speed must be 0.1 to 100 times: 0.0");
    }

    /** Recordings of real vehicles, where they are at hand. */
    private DroneState replayed(String name) throws IOException {
        String folder = System.getenv("DRONEMAP_TEST_DATA");
        Assumptions.assumeTrue(folder != null, "DRONEMAP_TEST_DATA is not set; recordings are not played");
        Path file = Path.of(folder, "tlogs", name);
        RecordingReplay replay = cloud.proxy()
                .replays()
                .start(new ReplayRegistry.Source(name, Files.newInputStream(file), Files.size(file), 100));
        awaitState(replay, ReplayStatus.State.FINISHED);
        TestCloud.await(
                time, Duration.ofSeconds(5), () -> replay.status().drones().size() == 1, () -> "not one drone");
        List<DroneState> drones = cloud.cloud().drones();
        assertThat(drones).hasSize(1);
        DroneState drone = drones.get(0);
        assertThat(drone.identification().kind()).isEqualTo(VehicleKind.SUBMARINE);
        assertThat(drone.identification().autopilot()).isEqualTo("ArduPilot");
        assertThat(drone.identification().vehicle()).isEqualTo("ArduSub");
        assertThat(drone.battery().percent()).isNull();
        return drone;
    }

    @Test
    void showsARealSubmarineWithItsPosition() throws IOException {
        DroneState drone = replayed("ardusub_small.tlog");

        assertThat(drone.mode()).isEqualTo("MANUAL");
        assertThat(drone.identification().firmware()).isEqualTo("4.1.1");
        assertThat(drone.position().point().latitudeDegrees()).isBetween(48.0, 49.0);
        assertThat(drone.battery().volts()).isBetween(14.0, 17.0);
    }

    @Test
    void showsARealSubmarineWithoutAPositionThatItNeverHad() throws IOException {
        DroneState drone = replayed("mavlinkserver_00025.tlog");

        assertThat(drone.position().point()).isNull();
        assertThat(drone.position().altitudeAmslMeters()).isNull();
    }

    @Test
    void losesNoGoodMessageOfARecordingWithBrokenBytes() throws IOException {
        DroneState drone = replayed("ardusub_pymavlink_bug_2023-04-18.tlog");

        assertThat(drone.position().point()).isNull();
        assertThat(cloud.proxy().replays().all().get(0).status().goodMessages()).isEqualTo(50_136);
    }
}
