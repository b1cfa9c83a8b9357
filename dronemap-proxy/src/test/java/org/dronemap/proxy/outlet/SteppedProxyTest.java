package org.dronemap.proxy.outlet;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.link.RobotKey;
import org.dronemap.core.recording.Recording;
import org.dronemap.core.recording.RecordingPolicy;
import org.dronemap.core.time.ScheduledTask;
import org.dronemap.core.time.SteppedTime;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.signing.OutgoingSigner;
import org.dronemap.mavlink.signing.SigningClock;
import org.dronemap.mavlink.signing.SigningKey;
import org.dronemap.proxy.FakeVehicle;
import org.dronemap.proxy.TestCloud;
import org.dronemap.proxy.endpoint.DtlsKeys;
import org.dronemap.proxy.endpoint.EndpointSecurity;
import org.dronemap.proxy.endpoint.MemoryLink;
import org.dronemap.proxy.endpoint.PeerAddress;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.dronemap.proxy.record.Recorder;
import org.dronemap.proxy.record.RecordingReplay;
import org.dronemap.proxy.record.ReplayRegistry;
import org.dronemap.proxy.record.ReplayStatus;
import org.dronemap.proxy.record.TestRecordingStore;
import org.dronemap.proxy.record.TextMessageTap;
import org.dronemap.proxy.roslink.RobotKeys;
import org.dronemap.proxy.roslink.RoslinkConnector;
import org.dronemap.proxy.session.Enrolment;
import org.dronemap.proxy.session.FrameTap;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Links, recordings and the outlet in stepped time: nothing of them waits for a thread. */
class SteppedProxyTest {
    private static final Duration PATIENCE = Duration.ofSeconds(10);
    private static final Duration BEAT = Duration.ofMillis(200);
    private static final Duration RECORD = Duration.ofMillis(100);

    @TempDir
    Path directory;

    private final SteppedTime time = new SteppedTime(Instant.parse("2026-03-04T05:06:07Z"));
    private final StoreWriter journal = new StoreWriter(time);
    private final Taps taps = new Taps();
    private final TestCloud cloud = new TestCloud(taps, time);
    private final Outlet outlet = new Outlet(
            List.of(),
            new OutletDependencies(
                    cloud.cloud(),
                    new TestOutletStore(),
                    journal,
                    user -> Optional.of(new Principal(user, Role.OPERATOR)),
                    (by, drone, event) -> cloud.cloud().controls().apply(drone, event),
                    time),
            EndpointSecurity.of(DtlsKeys.none()));
    private Recorder recorder;
    private volatile Heartbeat heartbeat = FakeVehicle.copter(4, false);

    /** Of the recorder and the outlet, once they are there. */
    private static final class Taps implements FrameTap.Factory {
        private FrameTap.Factory both = componentId -> FrameTap.NONE;

        @Override
        public FrameTap open(int componentId) {
            return both.open(componentId);
        }
    }

    @BeforeEach
    void start() throws IOException {
        recorder = new Recorder(
                directory,
                RecordingPolicy.DEFAULT,
                new Recorder.Dependencies(new TestRecordingStore(), journal, drone -> "Copter 1"),
                time);
        recorder.start();
        outlet.start(false);
        taps.both = componentId -> FrameTap.both(recorder.open(componentId), outlet.open(componentId));
    }

    @AfterEach
    void close() {
        outlet.close();
        recorder.close();
        cloud.close();
        journal.close();
        assertThat(time.failures()).isEmpty();
    }

    private ScheduledTask everyBeat(String who, Runnable says) {
        return time.worker(who, 1).every(Duration.ZERO, BEAT, says);
    }

    private static MemoryLink link(PeerHandler.Factory handlers, int port, List<Frame> heard, SteppedTime time) {
        FrameReader reader = new FrameReader();
        return new MemoryLink(
                handlers,
                new PeerAddress("127.0.0.1", port),
                frame -> reader.read(ByteBuffer.wrap(frame), heard::add),
                time);
    }

    private MemoryLink vehicle() {
        MemoryLink link = link(cloud.proxy().handlers(), 14_551, new ArrayList<>(), time);
        FrameWriter writer = new FrameWriter(7, 1, 2);
        ScheduledTask unused = everyBeat("vehicle", () -> link.received(writer.frame(heartbeat)));
        return link;
    }

    private Optional<DroneState> drone() {
        return cloud.cloud().drones().stream().findFirst();
    }

    @Test
    void aVehicleComesAndIsLost() {
        MemoryLink link = vehicle();
        assertThat(time.advanceUntil(() -> drone().isPresent(), PATIENCE)).isTrue();
        link.close();

        assertThat(time.advanceUntil(
                        () -> drone().orElseThrow().link().state() == LinkState.LOST, Duration.ofMinutes(1)))
                .isTrue();
    }

    @Test
    void aFlightIsRecorded() throws IOException {
        vehicle();
        assertThat(time.advanceUntil(() -> drone().isPresent(), PATIENCE)).isTrue();
        heartbeat = FakeVehicle.copter(4, true);
        time.advance(Duration.ofSeconds(20));
        String id = recorder.archive().recordings().get(0).id();
        assertThat(recorder.archive().file(id)).isPresent();
        heartbeat = FakeVehicle.copter(4, false);
        time.advance(Duration.ofSeconds(7));

        Recording done = recorder.archive().recording(id).orElseThrow();
        assertThat(done.state()).isEqualTo(Recording.State.COMPLETE);
        assertThat(done.frames()).isGreaterThanOrEqualTo(100);
    }

    @Test
    void aClientOfTheOutletSeesAVehicle() {
        vehicle();
        assertThat(outlet.putKey("ann", MatrixClient.key("ann"))).isTrue();
        List<Frame> heard = new ArrayList<>();
        MemoryLink client = link(outlet, 14_560, heard, time);
        OutgoingSigner signer = new OutgoingSigner(
                new SigningKey(MatrixClient.key("ann").secret()), new SigningClock(time.clock(), 0), 1);
        FrameWriter writer = new FrameWriter(254, 190, 2);
        ScheduledTask unused =
                everyBeat("client", () -> client.received(writer.frame(new Heartbeat(6, 8, 0, 0, 4, 3), signer)));

        assertThat(time.advanceUntil(
                        () -> heard.stream()
                                .anyMatch(frame -> frame.messageId() == Heartbeat.ID && frame.systemId() == 7),
                        PATIENCE))
                .isTrue();
        assertThat(outlet.status().clients()).hasSize(1);
    }

    @Test
    void aRobotComes() {
        RobotKeys keys = new RobotKeys() {
            @Override
            public Optional<RobotKey> find(String key) {
                return Optional.empty();
            }

            @Override
            public boolean isOfIssuedForm(String key) {
                return false;
            }

            @Override
            public boolean isValid(RobotKey key) {
                return false;
            }
        };
        RoslinkConnector.Policy policy = new RoslinkConnector.Policy(
                keys, () -> TextMessageTap.NONE, EndpointSecurity.of(DtlsKeys.none()), Enrolment.LOOPBACK);
        try (RoslinkConnector robots = new RoslinkConnector(cloud.cloud(), cloud.lanes(), List.of(), policy, time)) {
            MemoryLink robot =
                    new MemoryLink(robots.handlers(), new PeerAddress("127.0.0.1", 14_570), frame -> {}, time);
            ScheduledTask unused = everyBeat(
                    "robot",
                    () -> robot.received(("{\"header\":{\"roslink_version\":1,\"ros_version\":8,\"system_id\":9,"
                                    + "\"message_id\":0,\"sequence_number\":1,\"key\":\"a word\"},\"type\":8}")
                            .getBytes(StandardCharsets.UTF_8)));

            assertThat(time.advanceUntil(() -> drone().isPresent(), PATIENCE)).isTrue();
            assertThat(drone().orElseThrow().link().key().systemId()).isEqualTo(9);
        }
    }

    @Test
    void aRecordingPlaysInItsOwnTime() {
        FrameWriter writer = new FrameWriter(7, 1, 2);
        ByteBuffer bytes = ByteBuffer.allocate(10_000);
        for (int number = 0; number < 100; number++) {
            bytes.putLong(1_000_000_000_000_000L + number * RECORD.toNanos() / 1_000)
                    .put(writer.frame(heartbeat));
        }
        RecordingReplay replay = cloud.proxy()
                .replays()
                .start(new ReplayRegistry.Source(
                        "flight", new ByteArrayInputStream(bytes.array(), 0, bytes.position()), bytes.position(), 2));
        Duration whole = RECORD.multipliedBy(100).dividedBy(2);
        time.advance(whole.minusMillis(200));
        assertThat(replay.status().state()).isEqualTo(ReplayStatus.State.RUNNING);
        time.advance(Duration.ofMillis(400));

        assertThat(replay.status().state()).isEqualTo(ReplayStatus.State.FINISHED);
        assertThat(replay.status().records()).isEqualTo(100);
        assertThat(drone().orElseThrow().replay()).isTrue();
    }
}
