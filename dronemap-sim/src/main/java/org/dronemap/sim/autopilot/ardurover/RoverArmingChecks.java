package org.dronemap.sim.autopilot.ardurover;

import org.dronemap.sim.autopilot.ardupilot.ArmingChecks;
import org.dronemap.sim.autopilot.ardupilot.BatteryFailsafe;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedMission;
import org.dronemap.sim.flight.SimulatedParameters;

/** The pre-arm checks of the simulated ArduRover: what is driven by hand is armed without a position. */
final class RoverArmingChecks extends ArmingChecks {
    private static final String NO_POSITION = "AHRS: not using configured AHRS type";

    RoverArmingChecks(
            SimulatedCraft craft, SimulatedParameters parameters, SimulatedMission plan, BatteryFailsafe battery) {
        super(craft, parameters, plan, battery);
    }

    @Override
    protected boolean wantsPositionInEveryMode() {
        return false;
    }

    /** Its home is where the first fix is. */
    @Override
    protected String withoutFix() {
        return "AHRS: waiting for home";
    }

    @Override
    protected String withoutOrigin() {
        return NO_POSITION;
    }

    @Override
    protected String withoutEstimate() {
        return NO_POSITION;
    }
}
