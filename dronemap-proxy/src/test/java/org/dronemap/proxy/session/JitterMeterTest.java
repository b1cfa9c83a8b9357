package org.dronemap.proxy.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Objects;
import java.util.Random;
import org.junit.jupiter.api.Test;

class JitterMeterTest {
    private static final int KIND = 30;

    private final JitterMeter meter = new JitterMeter();
    private final Random random = new Random(7);

    /** Ten a second by the sender's clock, which goes {@code rate} times as fast as ours. */
    private void receive(double fromSeconds, double seconds, double rate, double scatterSeconds) {
        for (int i = 0; i < seconds * 10; i++) {
            double at = fromSeconds + i / 10.0;
            meter.arrived(KIND, at * rate, nanos(at + scatterSeconds * random.nextDouble()));
        }
    }

    private static long nanos(double seconds) {
        return (long) (seconds * 1e9);
    }

    private double shortMillis() {
        return Objects.requireNonNull(meter.jitter().shortMillis());
    }

    private double longMillis() {
        return Objects.requireNonNull(meter.jitter().longMillis());
    }

    @Test
    void messagesThatTakeTheSameTimeDoNotJitter() {
        receive(0, 20, 1, 0);
        assertThat(shortMillis()).isCloseTo(0, within(0.001));
    }

    @Test
    void isTheMeanDifferenceOfTwoTransitTimes() {
        receive(0, 120, 1, 0.09);
        // Of two even chances within 90 ms: a third.
        assertThat(longMillis()).isCloseTo(30, within(3.0));
    }

    @Test
    void shortFollowsSoonerThanLong() {
        receive(0, 60, 1, 0.01);
        receive(60, 10, 1, 0.09);
        assertThat(shortMillis()).isGreaterThan(2 * longMillis());
    }

    @Test
    void aClockThatGoesFasterIsNoJitter() {
        receive(0, 60, 10, 0);
        assertThat(shortMillis()).isCloseTo(0, within(0.1));
    }

    @Test
    void copiesAndOvertakenMessagesAreLeftOut() {
        receive(0, 10, 1, 0);
        meter.arrived(KIND, 9.5, nanos(10.4));
        meter.arrived(KIND, 9.9, nanos(10.5));
        receive(10, 10, 1, 0);
        assertThat(shortMillis()).isCloseTo(0, within(0.001));
    }

    @Test
    void aVehicleThatBeginsAnewDoesNotJitter() {
        receive(1_000, 10, 1, 0);
        for (int i = 0; i < 100; i++) {
            meter.arrived(KIND, i / 10.0, nanos(1_010 + i / 10.0));
        }
        assertThat(shortMillis()).isCloseTo(0, within(0.001));
    }

    @Test
    void lostHeartbeatsAreNoJitter() {
        for (int i = 0; i < 60; i++) {
            if (i % 7 != 0) {
                meter.arrivedInTurn(0, 1, nanos(i));
            }
        }
        assertThat(longMillis()).isCloseTo(0, within(0.001));
    }

    @Test
    void heartbeatsThatComeUnevenlyJitter() {
        for (int i = 0; i < 120; i++) {
            meter.arrivedInTurn(0, 1, nanos(i + 0.3 * random.nextDouble()));
        }
        assertThat(longMillis()).isBetween(70.0, 130.0);
    }

    @Test
    void isUnknownWhileTooLittleCame() {
        meter.arrived(KIND, 0, 0);
        meter.arrived(KIND, 1, nanos(1));
        assertThat(meter.jitter()).isEqualTo(JitterMeter.Jitter.UNKNOWN);
    }
}
