package org.dronemap.proxy.record;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.recording.Recording;
import org.dronemap.core.recording.RecordingPolicy;
import org.dronemap.core.time.RealTime;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.session.FrameTap;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What is recorded of a drone that changes hands: the recording of before ends, and the next one has nothing of it. */
class SplitRecordingTest {
    private static final DroneId DRONE = new DroneId("d1");
    private static final Instant START = Instant.parse("2026-03-04T05:06:07Z");

    @TempDir
    Path directory;

    private final ManualClock clock = new ManualClock(START);

    @AutoClose
    private final StoreWriter journal = new StoreWriter(new RealTime());

    private final FrameWriter vehicle = new FrameWriter(1, 1, 2);

    @AutoClose
    private Recorder recorder;

    private FrameTap tap;

    @BeforeEach
    void begin() throws IOException {
        Recorder.Dependencies keeping =
                new Recorder.Dependencies(new TestRecordingStore(), journal, drone -> "Copter 1");
        recorder = new Recorder(directory, RecordingPolicy.DEFAULT, keeping, new RealTime(clock), () -> Long.MAX_VALUE);
        recorder.start();
        tap = recorder.open(1);
        tap.bound(DRONE);
        hears(true);
        clock.pass(1);
        hears(false);
        clock.pass(1);
    }

    private void hears(boolean armed) {
        byte[] raw = vehicle.frame(new Heartbeat(2, 3, armed ? 0x81 : 1, 4, 4, 3));
        new FrameReader().read(ByteBuffer.wrap(raw), tap::received);
    }

    private Recording newest() throws IOException {
        recorder.flush();
        return recorder.archive().recordings().get(0);
    }

    @Test
    void endsThoughItsLastSecondsAreNotOver() throws IOException {
        assertThat(newest().state()).isEqualTo(Recording.State.RUNNING);

        recorder.archive().part(DRONE);

        Recording before = newest();
        assertThat(before.state()).isEqualTo(Recording.State.COMPLETE);
        assertThat(before.frames()).isEqualTo(2);
    }

    @Test
    void theNextOneHasNothingOfWhatCameBefore() throws IOException {
        clock.pass(6);
        hears(false);
        recorder.archive().part(DRONE);
        clock.pass(1);
        hears(true);

        List<Recording> all = List.of(newest());
        assertThat(all.get(0).start()).isEqualTo(START.plusSeconds(9));
        assertThat(all.get(0).frames()).isEqualTo(1);
    }
}
