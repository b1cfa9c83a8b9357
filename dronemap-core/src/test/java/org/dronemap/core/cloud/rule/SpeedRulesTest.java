package org.dronemap.core.cloud.rule;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Optional;
import org.dronemap.core.command.ChangeSpeed;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.VehicleKind;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SpeedRulesTest {
    private static Optional<Refusal> why(JudgedDrone drone, double speed) {
        return CommandRules.whyNot(drone.state(), new ChangeSpeed(speed));
    }

    @ParameterizedTest
    @CsvSource({
        "MULTICOPTER, 0.2, 30, 0.1, 31",
        "FIXED_WING, 3, 100, 2.9, 2",
        "ROVER, 0.1, 30, 30.5, 99",
        "SUBMARINE, 0.2, 30, 0.15, 31",
        "VTOL, 0.1, 100, 0, 0"
    })
    void takesTheSpeedsOfItsKind(VehicleKind kind, double slowest, double fastest, double slower, double faster) {
        JudgedDrone drone = JudgedDrone.of(kind);

        assertThat(why(drone, slowest)).isEmpty();
        assertThat(why(drone, fastest)).isEmpty();
        for (double wrong : new double[] {slower, faster}) {
            if (wrong > 0) {
                assertThat(why(drone, wrong)).hasValueSatisfying(why -> {
                    assertThat(why.code()).isEqualTo(OutcomeCode.SPEED_NOT_POSSIBLE);
                    assertThat(why.sentence()).startsWith("metersPerSecond must be ");
                });
            }
        }
    }

    @Test
    void namesFieldRangeAndKind() {
        assertThat(why(JudgedDrone.of(VehicleKind.FIXED_WING), 2.5))
                .map(Refusal::sentence)
                .hasValue("metersPerSecond must be 3 to 100 for a vehicle of this kind (fixed wing), not 2.5.");
    }

    @Test
    void saysInWhichModeItGoesByASpeed() {
        JudgedDrone copter = JudgedDrone.of(VehicleKind.MULTICOPTER);

        assertThat(why(copter.in("AUTO"), 5)).isEmpty();
        for (String mode : new String[] {"RTL", "BRAKE", "LOITER"}) {
            assertThat(why(copter.in(mode), 5))
                    .hasValue(new Refusal(
                            OutcomeCode.MODE_NOT_STEERABLE,
                            "In " + mode + " it does not go by such a speed; change its mode to GUIDED first."));
        }
    }

    @Test
    void needsAVehicleThatCanAndIsUnderWay() {
        JudgedDrone copter = JudgedDrone.of(VehicleKind.MULTICOPTER);

        assertThat(why(copter.without(Capability.CHANGE_SPEED), 5))
                .map(Refusal::code)
                .hasValue(OutcomeCode.CAPABILITY_MISSING);
        assertThat(why(copter.disarmed(), 5)).map(Refusal::code).hasValue(OutcomeCode.NOT_ARMED);
        assertThat(why(copter.at(0), 5)).map(Refusal::code).hasValue(OutcomeCode.NOT_AIRBORNE);
    }

    @Test
    void takesNoSpeedThatNoVehicleGoes() {
        for (double none : new double[] {0, -1, -2, 100.5, Double.NaN, Double.POSITIVE_INFINITY}) {
            assertThatThrownBy(() -> new ChangeSpeed(none))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("0.1 to 100 m/s");
        }
    }
}
