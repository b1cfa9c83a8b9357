package org.dronemap.proxy.record;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import org.dronemap.core.drone.DroneId;
import org.junit.jupiter.api.Test;

/** From when until when a session is recorded. */
class RecordingBufferTest {
    private final ManualClock clock = new ManualClock(Instant.parse("2026-03-04T05:06:07Z"));
    private final FrameRecordingBuffer tape = new FrameRecordingBuffer(clock, new BufferBudget(1 << 20), 1, false);

    @Test
    void endsSecondsAfterTheFlightThoughTheVehicleGoesOnSayingThatItIsDisarmed() {
        tape.bound(new DroneId("d1"));
        tape.arming(true);
        clock.pass(60);
        for (int second = 0; second <= 5; second++) {
            tape.arming(false);
            assertThat(tape.isRecording()).as("second %d on the ground", second).isTrue();
            clock.pass(1);
        }

        tape.arming(false);

        assertThat(tape.isRecording()).isFalse();
    }
}
