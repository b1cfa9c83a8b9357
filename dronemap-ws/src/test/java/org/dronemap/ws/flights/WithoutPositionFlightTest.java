package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.Objects;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.ws.command.CommandRequest;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.VehicleSpec;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** A vehicle that lost its position says what it can still do, and does that when it is asked. */
class WithoutPositionFlightTest {
    private static final long ALT_HOLD = 2;
    private static final long LAND = 9;
    private static final Duration SOON = Duration.ofSeconds(30);

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ann = lab.pilot("ann", Role.OPERATOR);

    @AfterEach
    void close() {
        lab.close();
    }

    private void requirePositionMissing(LabDrone drone, CommandRequest wish, String instead) {
        CommandView.OutcomeView refused =
                Objects.requireNonNull(ann.outcome(drone, wish).outcome());
        assertThat(refused.code()).isEqualTo(OutcomeCode.POSITION_MISSING.word());
        assertThat(refused.by()).isEqualTo("vehicle");
        assertThat(refused.reason()).endsWith(instead);
    }

    @Test
    void aCopterCannotHoldAndIsLandedInstead() {
        LabDrone copter = lab.ready(lab.copters(1).get(0));
        ann.takesOff(copter, 20);
        copter.craft().navigation().setReceiving(false);
        lab.until("its fail-safe lands it", SOON, () -> copter.mode() == LAND);

        for (CommandRequest wish : new CommandRequest[] {CommandRequests.hold(), CommandRequests.returnToLaunch()}) {
            requirePositionMissing(
                    copter,
                    wish,
                    "Without a position it can land, or keep its height in ALT_HOLD while a pilot steers.");
            assertThat(copter.mode()).isEqualTo(LAND);
        }

        ann.does(copter, CommandRequests.setMode("ALT_HOLD"));
        assertThat(copter.mode()).isEqualTo(ALT_HOLD);
        ann.does(copter, CommandRequests.land());
        lab.until("it is down", Duration.ofMinutes(2), copter::isDown);
    }

    @Test
    void aRoverHoldsAndSaysSoWhenItCannotGoHome() {
        LabDrone rover = lab.ready(lab.add(VehicleSpec.ROVER));
        ann.does(rover, CommandRequests.setMode("GUIDED")).does(rover, CommandRequests.arm());
        rover.craft().navigation().setReceiving(false);
        lab.until(
                "it has lost its position",
                SOON,
                () -> !rover.craft().navigation().hasEstimate());

        requirePositionMissing(
                rover,
                CommandRequests.returnToLaunch(),
                "Without a position it can stand in HOLD, or be driven by a pilot in MANUAL.");
        ann.does(rover, CommandRequests.hold());
    }
}
