package org.dronemap.core.cloud.rule;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.core.command.Command;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.VehicleKind;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What drives, floats or dives is never in the air: neither on a hill above its home nor where it says so itself. */
class GroundVehicleRulesTest {
    @ParameterizedTest
    @EnumSource(
            value = VehicleKind.class,
            names = {"ROVER", "BOAT", "SUBMARINE"})
    void isNeverInTheAir(VehicleKind kind) {
        for (JudgedDrone drone : new JudgedDrone[] {
            JudgedDrone.of(kind).at(12),
            JudgedDrone.of(kind).at(-8),
            JudgedDrone.of(kind).at(12).says(FlightPhase.IN_AIR)
        }) {
            DroneState state = drone.state();

            assertThat(state.airborne()).isFalse();
            assertThat(state.isOnGround()).isTrue();
            assertThat(FlightFacts.isFlying(state)).isFalse();
            assertThat(CommandRules.whyNot(state, new Command.Disarm(false))).isEmpty();
            assertThat(CommandRules.whyNot(state, new Command.Turn(90))).isEmpty();
            assertThat(CommandRules.canHold(state)).isTrue();
        }
    }

    @Test
    void staysARuleForWhatFlies() {
        assertThat(CommandRules.whyNot(JudgedDrone.of(VehicleKind.VTOL).at(12).state(), new Command.Disarm(false)))
                .map(Refusal::code)
                .hasValue(OutcomeCode.DRONE_AIRBORNE);
        assertThat(JudgedDrone.of(VehicleKind.UNKNOWN).at(12).state().airborne())
                .isTrue();
    }
}
