package org.dronemap.core.cloud.rule;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.VehicleKind;
import org.junit.jupiter.api.Test;

/** A plane that cannot be told to take off or land is told how it does. */
class WingsRulesTest {
    private static Refusal why(JudgedDrone drone, Capability capability) {
        return CommandRules.whyNot(drone.state(), capability).orElseThrow();
    }

    @Test
    void takesOffAndLandsByAMission() {
        JudgedDrone plane = JudgedDrone.of(VehicleKind.FIXED_WING).without(Capability.TAKE_OFF, Capability.LAND);

        assertThat(why(plane, Capability.TAKE_OFF).code()).isEqualTo(OutcomeCode.CAPABILITY_MISSING);
        assertThat(why(plane, Capability.TAKE_OFF).sentence()).contains("cannot take off.", "begins with takeOff");
        assertThat(why(plane, Capability.LAND).sentence()).contains("cannot land.", "ends with land");
    }

    @Test
    void promisesNoMissionToWhatTakesNone() {
        JudgedDrone glider =
                JudgedDrone.of(VehicleKind.FIXED_WING).without(Capability.TAKE_OFF, Capability.START_MISSION);
        JudgedDrone rover = JudgedDrone.of(VehicleKind.ROVER).without(Capability.TAKE_OFF);

        assertThat(why(glider, Capability.TAKE_OFF).sentence()).endsWith("cannot take off.");
        assertThat(why(rover, Capability.TAKE_OFF).sentence()).endsWith("cannot take off.");
    }
}
