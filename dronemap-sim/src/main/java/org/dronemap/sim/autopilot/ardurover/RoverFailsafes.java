package org.dronemap.sim.autopilot.ardurover;

import org.dronemap.sim.autopilot.ardupilot.ArduPilotFailsafes;
import org.dronemap.sim.autopilot.ardupilot.BatteryFailsafe;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedParameters;
import org.dronemap.sim.flight.TextSeverity;

/** The fail-safes of the simulated ArduRover for battery, ground station or position loss. */
final class RoverFailsafes extends ArduPilotFailsafes {
    private static final int CONTINUE_MISSION = 2;
    private static final String TEXT = "Radio Failsafe";
    private static final int ALSO_IN_HOLD = 1;
    private static final int EKF_DISABLED = 0;
    private static final int EKF_HOLDS = 1;
    private static final long EKF_BAD_MILLIS = 1_000;
    private static final long EKF_TEXT_MILLIS = 30_000;
    private static final long NEVER = -1;

    private final SimulatedArduRover rover;
    private final SimulatedCraft craft;
    private final SimulatedParameters parameters;
    private long silentSince = NEVER;
    private boolean groundStationLost;
    private long positionBadSince = NEVER;
    private boolean positionLost;
    private long varianceToldAt = -EKF_TEXT_MILLIS;
    private boolean hadOrigin;

    RoverFailsafes(SimulatedArduRover rover, BatteryFailsafe battery) {
        super(rover, battery);
        this.rover = rover;
        this.craft = rover.craft();
        this.parameters = rover.parameters();
    }

    /** The battery's is not among them. */
    @Override
    public boolean any() {
        return groundStationLost || positionLost;
    }

    @Override
    protected void batteryFailed(int action) {
        act(action);
    }

    /** 0 nothing, 1 comes back, 2 holds, 3 and 4 come back the way it came or else hold, 5 stops the motors. */
    private void act(int action) {
        boolean done = switch (action) {
            case 0 -> true;
            case 1 -> rover.change(RoverMode.RTL);
            case 3 -> rover.change(RoverMode.SMART_RTL) || rover.change(RoverMode.RTL);
            case 4 -> rover.change(RoverMode.SMART_RTL);
            case 5 -> {
                rover.disarm(true);
                yield true;
            }
            default -> false;
        };
        if (!done) {
            rover.change(RoverMode.HOLD);
        }
    }

    @Override
    protected void checkOwn(long nowMillis) {
        checkGroundStation(nowMillis);
        checkPosition(nowMillis);
    }

    /** Silence trips it after FS_GCS_TIMEOUT and FS_TIMEOUT, but not on the way home nor in HOLD. */
    private void checkGroundStation(long nowMillis) {
        if (parameters.value("FS_GCS_ENABLE") == 0) {
            return;
        }
        if (!groundStationSilent(nowMillis, parameters.value("FS_GCS_TIMEOUT"))) {
            silentSince = NEVER;
            if (groundStationLost) {
                groundStationLost = false;
                rover.sendText(TextSeverity.INFO, "GCS Failsafe Cleared");
            }
            return;
        }
        if (silentSince == NEVER) {
            silentSince = nowMillis;
        }
        boolean tooLong = nowMillis - silentSince > parameters.value("FS_TIMEOUT") * 1000;
        if (!groundStationLost && tooLong && mayTrip()) {
            groundStationLost = true;
            groundStationFailed();
        }
    }

    private boolean mayTrip() {
        RoverMode mode = rover.flight().mode();
        boolean inHold = mode == RoverMode.HOLD && ((int) parameters.value("FS_OPTIONS") & ALSO_IN_HOLD) == 0;
        return mode != RoverMode.RTL && !inHold;
    }

    /** It names the radio, and goes on with a mission only if it may without a radio: so the real one does. */
    private void groundStationFailed() {
        rover.sendText(TextSeverity.WARNING, TEXT);
        boolean mayContinue = parameters.value("FS_THR_ENABLE") == CONTINUE_MISSION;
        if (mayContinue && rover.flight().mode() == RoverMode.AUTO) {
            rover.sendText(TextSeverity.WARNING, "Failsafe - Continuing Auto Mode");
        } else {
            act((int) parameters.value("FS_ACTION"));
        }
    }

    private void checkPosition(long nowMillis) {
        hadOrigin |= craft.navigation().hasOrigin();
        boolean bad = craft.armed() && hadOrigin && !craft.navigation().hasEstimate();
        if (!bad) {
            positionBadSince = NEVER;
            if (positionLost) {
                positionLost = false;
                rover.sendText(TextSeverity.CRITICAL, "EKF failsafe cleared");
            }
            return;
        }
        if (positionBadSince == NEVER) {
            positionBadSince = nowMillis;
        }
        if (!positionLost && nowMillis - positionBadSince >= EKF_BAD_MILLIS) {
            positionLost = true;
            positionFailed(nowMillis);
        }
    }

    private void positionFailed(long nowMillis) {
        if (nowMillis - varianceToldAt >= EKF_TEXT_MILLIS) {
            varianceToldAt = nowMillis;
            rover.sendText(TextSeverity.CRITICAL, "EKF variance");
        }
        int action = (int) parameters.value("FS_EKF_ACTION");
        if (!rover.flight().mode().needsPosition() || action == EKF_DISABLED) {
            return;
        }
        if (action == EKF_HOLDS) {
            rover.change(RoverMode.HOLD);
        }
        rover.sendText(TextSeverity.CRITICAL, "EKF failsafe");
    }
}
