package org.dronemap.proxy.mavlink.procedure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronemap.mavlink.message.Timesync;
import org.junit.jupiter.api.Test;

class RoundTripProbeTest {
    private static final long SECOND = 1_000_000_000L;

    private final TestWire wire = new TestWire();
    private final RoundTripProbe probe = new RoundTripProbe(wire.target(), new RoundTripEstimator());
    private long now = 1_000 * SECOND;

    private void run(long nanos) {
        for (long end = now + nanos; now < end; now += TestWire.TICK_NANOS) {
            probe.advance(now);
        }
    }

    private Timesync lastQuestion() {
        List<Timesync> questions = wire.sent(Timesync.class);
        return questions.get(questions.size() - 1);
    }

    private void hear(Timesync answer) {
        probe.received(wire.frame(answer), now);
    }

    @Test
    void measuresWhatAnAnswerTook() {
        probe.advance(now);
        now += 35_000_000L;
        hear(new Timesync(5, lastQuestion().ts1(), 255, 190));

        assertThat(probe.roundTrip().smoothedMillis()).isEqualTo(35.0);
    }

    @Test
    void countsNoAnswerTwiceAndNoneToSomebodyElse() {
        probe.advance(now);
        long asked = lastQuestion().ts1();
        hear(new Timesync(5, asked, 254, 1));
        hear(new Timesync(5, asked + 1, 255, 190));
        hear(new Timesync(0, asked, 0, 0));
        assertThat(probe.roundTrip().smoothedMillis()).isNull();

        now += 10_000_000L;
        hear(new Timesync(5, asked, 0, 0));
        now += 90_000_000L;
        hear(new Timesync(5, asked, 0, 0));
        assertThat(probe.roundTrip().smoothedMillis()).isEqualTo(10.0);
    }

    @Test
    void asksAMuteVehicleRarely() {
        run(120 * SECOND);
        assertThat(wire.sent(Timesync.class)).hasSizeBetween(8, 12);
    }

    @Test
    void takesItsOwnStallForNoRoundTrip() {
        probe.advance(now);
        long asked = lastQuestion().ts1();
        now += 10 * SECOND;
        probe.advance(now);
        hear(new Timesync(5, asked, 255, 190));

        assertThat(probe.roundTrip().smoothedMillis()).isNull();
    }
}
