package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.time.Duration;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.ScriptedPeer;
import org.dronemap.ws.plan.PlanDroneFactory;
import org.dronemap.ws.problem.Rejection;
import org.junit.jupiter.api.Test;

/** A drone that cannot fly missions is in no plan and in no run, and the reason is said before anything is planned. */
class PlanChoiceTest {
    private static final int QUADROTOR = 2;
    private static final int GENERIC = 0;

    @Test
    void whatFliesNoMissionsIsRefusedByName() {
        try (Laboratory lab = new Laboratory(1)) {
            ScriptedPeer peer = lab.peer(1, ScriptedPeer.Kind.vehicle(QUADROTOR, GENERIC), ScriptedPeer.OBEDIENT);
            lab.until(
                    "it is known",
                    Duration.ofSeconds(30),
                    () -> peer.known()
                            .filter(state -> state.identification().kind() == VehicleKind.MULTICOPTER)
                            .filter(state -> state.capabilities().known())
                            .isPresent());
            DroneState copter = peer.state();

            Rejection refused = catchThrowableOfType(Rejection.class, () -> PlanDroneFactory.of(copter));

            assertThat(refused.code().word()).isEqualTo(OutcomeCode.CAPABILITY_MISSING.word());
            assertThat(refused.sentence())
                    .isEqualTo("“" + copter.name() + "” ("
                            + copter.identification().vehicle() + ") does not fly missions.");
        }
    }
}
