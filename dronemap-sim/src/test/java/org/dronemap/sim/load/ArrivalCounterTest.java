package org.dronemap.sim.load;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import org.junit.jupiter.api.Test;

/** Frames count at a ground station by when they were due, whenever the test runs. */
class ArrivalCounterTest {
    private static final int RATE = 20;
    private static final long SECOND_NANOS = 1_000_000_000L;
    private static final SendSchedule PACE = new SendSchedule(0, 2, RATE);

    private final LoadFrames first = new LoadFrames(0, RATE, false);
    private final LoadFrames second = new LoadFrames(1, RATE, false);
    private final ArrivalCounter arrivals = new ArrivalCounter(PACE, 2 * SECOND_NANOS, 4 * SECOND_NANOS);

    @Test
    void countsWhatWasDueInTheSpanOfEachVehicle() {
        say(first, 5 * RATE);
        say(second, 5 * RATE);
        assertThat(arrivals.frames()).isEqualTo(2 * 2 * RATE);
        assertThat(arrivals.complete()).isTrue();
    }

    @Test
    void waitsForTheLastOfEachVehicle() {
        say(first, 5 * RATE);
        say(second, 4 * RATE);
        assertThat(arrivals.complete()).isFalse();
        arrivals.came(ByteBuffer.wrap(second.disarmed()));
        assertThat(arrivals.complete()).isTrue();
        assertThat(arrivals.frames()).isEqualTo(2 * 2 * RATE);
    }

    @Test
    void missesWhatDidNotCome() {
        say(first, 5 * RATE);
        for (int step = 0; step < 5 * RATE; step++) {
            byte[] frame = second.next();
            if (step < 2 * RATE + 1 || step >= 3 * RATE + 1) {
                arrivals.came(ByteBuffer.wrap(frame));
            }
        }
        assertThat(arrivals.frames()).isEqualTo(3 * RATE);
    }

    private void say(LoadFrames vehicle, int steps) {
        for (int step = 0; step < steps; step++) {
            arrivals.came(ByteBuffer.wrap(vehicle.next()));
        }
    }
}
