package org.dronemap.proxy.mavlink.procedure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class RoundTripEstimatorTest {
    private static final long MILLI = 1_000_000L;

    private final RoundTripEstimator roundTrip = new RoundTripEstimator();

    @Test
    void isUnknownUntilMeasured() {
        assertThat(roundTrip.smoothedMillis()).isNull();
        assertThat(roundTrip.patienceNanos(MILLI, 100 * MILLI, 80 * MILLI)).isEqualTo(80 * MILLI);
    }

    @Test
    void settlesOnASteadyLinkAndWaitsLittleLonger() {
        for (int i = 0; i < 100; i++) {
            roundTrip.measured(40 * MILLI);
        }

        assertThat(roundTrip.smoothedMillis()).isEqualTo(40.0);
        assertThat(roundTrip.patienceNanos(MILLI, 1000 * MILLI, 0)).isBetween(40 * MILLI, 42 * MILLI);
    }

    @Test
    void waitsLongerOnAnUnsteadyLinkButNeverBeyondTheBound() {
        for (int i = 0; i < 100; i++) {
            roundTrip.measured((i % 2 == 0 ? 100 : 900) * MILLI);
        }

        assertThat(roundTrip.patienceNanos(MILLI, 10_000 * MILLI, 0)).isGreaterThan(1_500 * MILLI);
        assertThat(roundTrip.patienceNanos(MILLI, 1_000 * MILLI, 0)).isEqualTo(1_000 * MILLI);
    }

    @Test
    void refusesATripThatEndedBeforeItBegan() {
        assertThatThrownBy(() -> roundTrip.measured(-1)).hasMessageContaining("-1 ns");
    }
}
