package org.dronemap.sim.autopilot.arduplane;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.sim.autopilot.ardupilot.ArduPilotMode;
import org.dronemap.sim.autopilot.ardupilot.ArmingChecks;
import org.dronemap.sim.autopilot.ardupilot.BatteryFailsafe;
import org.dronemap.sim.flight.NavigationEstimator;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedMission;
import org.dronemap.sim.flight.SimulatedParameters;

/** The pre-arm checks of the simulated ArduPlane: beside those of all vehicles those of its landing sequence. */
final class PlaneArmingChecks extends ArmingChecks {
    private final SimulatedParameters parameters;
    private final PlaneFlight flight;
    private final NavigationEstimator navigation;
    private boolean hadFix;

    PlaneArmingChecks(
            SimulatedCraft craft,
            SimulatedParameters parameters,
            SimulatedMission plan,
            BatteryFailsafe battery,
            PlaneFlight flight) {
        super(craft, parameters, plan, battery);
        this.parameters = parameters;
        this.flight = flight;
        this.navigation = craft.navigation();
    }

    /** It arms in every mode as soon as it has a fix, without waiting for its estimate. */
    @Override
    protected void checkPosition(ArduPilotMode mode, List<String> found) {
        hadFix |= navigation.hasFix();
        if (!navigation.hasFix()) {
            found.add(hadFix ? "GPS 1: Bad fix" : "AHRS: waiting for home");
        }
    }

    @Override
    public List<String> complaints(ArduPilotMode mode) {
        List<String> found = new ArrayList<>(super.complaints(mode));
        if (parameters.value("ARMING_CHECK") != 0
                && flight.landingSequence().exists()
                && parameters.value("RTL_AUTOLAND") == 0) {
            found.add("DO_LAND_START set and RTL_AUTOLAND disabled");
        }
        if (flight.staysInLanding()) {
            found.add("In landing sequence");
        }
        return found;
    }
}
