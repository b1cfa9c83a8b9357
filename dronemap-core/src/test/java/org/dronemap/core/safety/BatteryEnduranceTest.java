package org.dronemap.core.safety;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.Objects;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

class BatteryEnduranceTest {
    private final BatteryEndurance energy = new BatteryEndurance();

    private double after(double seconds, @Nullable Integer percent) {
        DroneState drone = ReturnPlannerTest.with(percent == null ? null : new Battery(percent, null, null));
        energy.observe(drone, (long) (seconds * 1e9));
        return energy.secondsLeft().orElse(Double.NaN);
    }

    @Test
    void assumesWhatASmallCopterTakesUntilItKnowsBetter() {
        assertThat(after(0, 100)).isEqualTo(1_200);
        assertThat(after(30, 99)).isEqualTo(1_188);
    }

    @Test
    void goesByWhatWasUsedUpInThisFlight() {
        assertThat(after(0, 100)).isEqualTo(1_200);
        assertThat(after(100, 90)).as("a tenth of a percent a second").isEqualTo(900);
    }

    @Test
    void goesOnSteadilyBetweenTwoWholeNumbers() {
        after(0, 100);
        after(100, 90);

        assertThat(after(105, 90)).isEqualTo(895);
        assertThat(after(109, 90)).isEqualTo(891);
    }

    @Test
    void drawsNothingFromTooLittleUsedUpOrTooShortATime() {
        after(0, 100);
        assertThat(after(100, 98)).as("two percent say nothing").isCloseTo(98 * 12, within(1e-6));

        BatteryEnduranceTest quick = new BatteryEnduranceTest();
        quick.after(0, 100);
        assertThat(quick.after(59, 90)).as("nor does less than a minute").isCloseTo(90 * 12, within(1e-6));
    }

    @Test
    void believesNoRateThatNoBatteryHas() {
        after(0, 100);
        assertThat(after(60, 10)).as("at most 40 % a minute").isCloseTo(15, within(1e-9));

        BatteryEnduranceTest slow = new BatteryEnduranceTest();
        slow.after(0, 100);
        assertThat(slow.after(6_000, 97)).as("at least half a percent a minute").isCloseTo(97 * 120, within(1e-6));
    }

    @Test
    void knowsNothingOfWhatIsNotTold() {
        assertThat(after(0, null)).isNaN();
        after(Duration.ofMinutes(1).toSeconds(), 50);
        assertThat(after(61, null)).isNaN();
    }

    @Test
    void countsTheClimbTheWayAndTheDescent() {
        DroneState high = ReturnPlannerTest.with(null);
        Geodetic below =
                Objects.requireNonNull(Objects.requireNonNull(high.position()).point());

        assertThat(BatteryEndurance.secondsTo(high, below, 0))
                .as("20 m down at 1 m/s")
                .hasValue(30 + 1.25 * 20);
        assertThat(BatteryEndurance.secondsTo(high, below, 60))
                .as("40 m up at 2 m/s, 60 m down")
                .hasValue(30 + 1.25 * (20 + 60));
        Geodetic away = new Geodetic(below.latitudeDegrees() + 0.001, below.longitudeDegrees());
        assertThat(BatteryEndurance.secondsTo(high, away, 0).orElseThrow())
                .as("111 m at 5 m/s")
                .isCloseTo(30 + 1.25 * (20 + 22.2), within(0.5));
    }
}
