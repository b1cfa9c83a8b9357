package org.dronemap.core.separation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** How drones gather speed and brake. */
class MotionProfileTest {
    private static final FlightPace SPEEDS = new FlightPace(10, 2.5, 1.5, 2);
    private static final FlightPace AT_ONCE = new FlightPace(10, 2.5, 1.5, Double.POSITIVE_INFINITY);

    @ParameterizedTest
    @CsvSource({"100, 0, 15", "50, 0, 10", "8, 0, 4", "100, 10, 12.5", "25, 10, 5", "0, 0, 0"})
    void takesAsLongAsItsAccelerationSays(double meters, double moving, double seconds) {
        assertThat(new MotionProfile(meters, moving, SPEEDS).seconds()).isCloseTo(seconds, within(1e-9));
    }

    @ParameterizedTest
    @CsvSource({"100, 0", "8, 0", "60, 4", "25, 10", "10, 10", "200, 12"})
    void goesOnAllTheTimeAndNeverFasterThanItMay(double meters, double moving) {
        MotionProfile dash = new MotionProfile(meters, moving, SPEEDS);
        double before = 0;
        for (double seconds = 0.05; seconds < dash.seconds(); seconds += 0.05) {
            double now = dash.share(seconds) * meters;
            assertThat(now - before).isBetween(0.0, 10 * 0.05 + 1e-6);
            before = now;
        }
        assertThat(dash.share(dash.seconds() - 1e-9)).isCloseTo(1, within(1e-6));
        assertThat(dash.share(0)).isCloseTo(0, within(1e-6));
    }

    @Test
    void knowsDronesThatMoveAtOnce() {
        MotionProfile dash = new MotionProfile(100, 0, AT_ONCE);

        assertThat(dash.seconds()).isEqualTo(10);
        assertThat(dash.share(5)).isEqualTo(0.5);
        assertThat(new MotionProfile(0, 0, AT_ONCE).share(0)).isEqualTo(1);
    }
}
