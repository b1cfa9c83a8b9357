package org.dronemap.sim.autopilot.ardupilot;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.sim.flight.NavigationEstimator;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedMission;
import org.dronemap.sim.flight.SimulatedParameters;

/** The pre-arm checks of a simulated ArduPilot vehicle, in ArduPilot's own words without "Arm: " or "PreArm: ". */
public class ArmingChecks {
    private final SimulatedCraft craft;
    private final SimulatedParameters parameters;
    private final SimulatedMission plan;
    private final BatteryFailsafe battery;

    public ArmingChecks(
            SimulatedCraft craft, SimulatedParameters parameters, SimulatedMission plan, BatteryFailsafe battery) {
        this.craft = craft;
        this.parameters = parameters;
        this.plan = plan;
        this.battery = battery;
    }

    /** What keeps it from arming in {@code mode}; empty when all is well. */
    public List<String> complaints(ArduPilotMode mode) {
        List<String> found = new ArrayList<>();
        if (parameters.value("ARMING_CHECK") != 0) {
            checkSensors(found);
            checkPosition(mode, found);
            checkBattery(found);
        }
        if (craft.crashed() || craft.motorFailed()) {
            found.add("Motors: Check frame class and type");
        }
        if (mode.needsMission() && plan.size() <= 1) {
            found.add("Mode requires mission");
        }
        return found;
    }

    private void checkSensors(List<String> found) {
        if (!craft.navigation().accelerometersSettled()) {
            found.add("Accels inconsistent");
        } else if (!craft.navigation().gyrosSettled()) {
            found.add("Gyros inconsistent");
        }
    }

    /** Until the sensors have settled a mode that flies without a position says nothing about it. */
    private void checkPosition(ArduPilotMode mode, List<String> found) {
        NavigationEstimator navigation = craft.navigation();
        if (!mode.needsPosition() && (!found.isEmpty() || !wantsPositionInEveryMode())) {
            return;
        }
        if (!navigation.hasFix()) {
            found.add(withoutFix());
        } else if (!navigation.hasOrigin()) {
            found.add(withoutOrigin());
        } else if (!navigation.hasEstimate()) {
            found.add(withoutEstimate());
        }
    }

    /** A mode that drives or flies without a position is not armed without one either. */
    protected boolean wantsPositionInEveryMode() {
        return true;
    }

    protected String withoutFix() {
        return "GPS 1: Bad fix";
    }

    protected String withoutOrigin() {
        return "AHRS: waiting for home";
    }

    protected String withoutEstimate() {
        return "Need Position Estimate";
    }

    private void checkBattery(List<String> found) {
        if (battery.volts() < parameters.value("BATT_CRT_VOLT")) {
            found.add("Battery 1 critical voltage failsafe");
        } else if (battery.volts() < parameters.value("BATT_LOW_VOLT") || battery.tripped()) {
            found.add("Battery 1 low voltage failsafe");
        }
        if (battery.tripped()) {
            found.add("Battery failsafe");
        }
    }
}
