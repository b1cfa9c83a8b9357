package org.dronemap.sim.autopilot.arducopter;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.sim.autopilot.ardupilot.ArduPilotMode;
import org.dronemap.sim.autopilot.ardupilot.ArmingChecks;
import org.dronemap.sim.autopilot.ardupilot.BatteryFailsafe;
import org.dronemap.sim.flight.NavigationEstimator;

/** The pre-arm checks of the simulated ArduCopter: those of all, its fence and its second battery. */
final class CopterChecks extends ArmingChecks {
    private static final String BATTERY_FAILSAFE = "Battery failsafe";

    private final SimulatedArduCopter copter;

    CopterChecks(SimulatedArduCopter copter, BatteryFailsafe battery) {
        super(copter.craft(), copter.parameters(), copter.plan(), battery);
        this.copter = copter;
    }

    @Override
    public List<String> complaints(ArduPilotMode mode) {
        List<String> found = new ArrayList<>(super.complaints(mode));
        if (copter.parameters().value("ARMING_CHECK") == 0) {
            return found;
        }
        addEarly(mode, found);
        found.addAll(copter.secondBattery().complaints());
        if (copter.secondBattery().tripped() && !found.contains(BATTERY_FAILSAFE)) {
            found.add(BATTERY_FAILSAFE);
        }
        String outside = copter.fence().complaint();
        if (!outside.isEmpty()) {
            found.add(outside);
        }
        return found;
    }

    /** What is said in the first seconds after power-up alone. */
    private void addEarly(ArduPilotMode mode, List<String> found) {
        NavigationEstimator navigation = copter.craft().navigation();
        if (navigation.tiltAligned()) {
            return;
        }
        found.add(found.isEmpty() ? 0 : 1, "EKF attitude is bad");
        if (mode.needsPosition()) {
            found.add(0, "Need Alt Estimate");
        } else if (!navigation.active()) {
            found.add("AHRS: not using configured AHRS type");
        }
    }

    /** STABILIZE and ALT_HOLD are armable long before there is a position. */
    @Override
    protected boolean wantsPositionInEveryMode() {
        return false;
    }

    /** A receiver that has just been switched on is waited for; one that has lost its signal is complained about. */
    @Override
    protected String withoutFix() {
        return copter.craft().navigation().isReceiving() ? withoutOrigin() : super.withoutFix();
    }
}
