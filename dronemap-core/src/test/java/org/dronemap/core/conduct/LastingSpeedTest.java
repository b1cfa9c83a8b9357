package org.dronemap.core.conduct;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;

class LastingSpeedTest {
    private final LastingSpeed speed = new LastingSpeed();

    private void observe(double... speeds) {
        DoubleStream.of(speeds).forEach(speed::observe);
    }

    /** Two reports of a place, the second of which came soon after the first, look like 20 m/s. */
    @Test
    void leavesOutSingleErrors() {
        observe(9.8, 20.4, 10.1, 9.9, 10);
        assertThat(speed.highest()).isEqualTo(9.9);
    }

    @Test
    void isNothingUntilItHasLasted() {
        observe(10, 10, 10);
        assertThat(speed.highest()).isZero();
    }

    @Test
    void keepsTheHighestAndBeginsAnewOnAnotherFlight() {
        observe(12, 12, 12, 12, 5, 5, 5, 5);
        assertThat(speed.highest()).isEqualTo(12);
        speed.interrupted();
        observe(15, 15, 15);
        assertThat(speed.highest()).isEqualTo(12);
    }
}
