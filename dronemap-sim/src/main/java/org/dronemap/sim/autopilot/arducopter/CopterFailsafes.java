package org.dronemap.sim.autopilot.arducopter;

import org.dronemap.sim.autopilot.ardupilot.ArduPilotFailsafes;
import org.dronemap.sim.autopilot.ardupilot.BatteryFailsafe;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.TextSeverity;

/** The fail-safes of the simulated ArduCopter for battery, ground station, GPS or motor loss. */
final class CopterFailsafes extends ArduPilotFailsafes {
    private static final int CONTINUE_AUTO_WITHOUT_GCS = 2;
    private static final int CONTINUE_LANDING = 8;
    private static final int CONTINUE_PILOTED_WITHOUT_GCS = 16;
    private static final long THRUST_LOSS_MILLIS = 5_000;
    private static final double GIVE_UP_METERS = 100;

    private final SimulatedArduCopter copter;
    private final SimulatedCraft craft;
    private final BatteryFailsafe battery;
    private boolean groundStationLost;
    private boolean positionLost;
    private boolean hadPosition;
    private boolean landsForIt;
    private long motorFailedAt = -1;
    private boolean thrustLossReported;

    CopterFailsafes(SimulatedArduCopter copter, BatteryFailsafe battery) {
        super(copter, battery);
        this.copter = copter;
        this.craft = copter.craft();
        this.battery = battery;
    }

    @Override
    public boolean any() {
        return battery.tripped() || copter.secondBattery().tripped() || groundStationLost || positionLost;
    }

    @Override
    protected void checkOwn(long nowMillis) {
        checkGroundStation(nowMillis);
        checkPosition();
        checkMotors(nowMillis);
        checkFence(nowMillis);
    }

    @Override
    protected void batteryFailed(int action) {
        copter.sendText(TextSeverity.WARNING, "Battery Failsafe");
        act(action);
    }

    /** 0 nothing, 1 land, 5 stop the motors, all others come back or else land. */
    private void act(int action) {
        if (action == 0) {
            return;
        }
        if (craft.landed() || action == 5) {
            copter.disarm(true);
        } else if (action == 1 || !craft.navigation().hasEstimate()) {
            copter.change(CopterMode.LAND);
        } else {
            copter.change(CopterMode.RTL);
        }
    }

    private void checkGroundStation(long nowMillis) {
        int action = (int) copter.parameters().value("FS_GCS_ENABLE");
        if (action == 0) {
            groundStationLost = false;
            return;
        }
        boolean lost = groundStationSilent(nowMillis, copter.parameters().value("FS_GCS_TIMEOUT"));
        if (lost && !groundStationLost) {
            groundStationLost = true;
            groundStationFailed(action);
        } else if (!lost && groundStationLost) {
            groundStationLost = false;
            copter.sendText(TextSeverity.WARNING, "GCS Failsafe Cleared");
        }
    }

    private void groundStationFailed(int action) {
        if (!craft.armed()) {
            return;
        }
        int options = (int) copter.parameters().value("FS_OPTIONS");
        CopterMode mode = copter.flight().mode();
        if (mode == CopterMode.AUTO && (options & CONTINUE_AUTO_WITHOUT_GCS) != 0) {
            copter.sendText(TextSeverity.WARNING, "GCS Failsafe - Continuing Auto Mode");
        } else if (mode == CopterMode.LAND && (options & CONTINUE_LANDING) != 0) {
            copter.sendText(TextSeverity.WARNING, "GCS Failsafe - Continuing Landing");
        } else if (mode.followsStick() && (options & CONTINUE_PILOTED_WITHOUT_GCS) != 0) {
            copter.sendText(TextSeverity.WARNING, "GCS Failsafe - Continuing Pilot Control");
        } else {
            copter.sendText(TextSeverity.WARNING, "GCS Failsafe");
            act(action == 5 ? 1 : 2);
        }
    }

    private void checkPosition() {
        boolean has = craft.navigation().hasEstimate();
        hadPosition |= has;
        if (hadPosition && !has && !positionLost) {
            positionLost = true;
            copter.sendText(TextSeverity.CRITICAL, "EKF variance");
            if (craft.armed() && copter.flight().mode().needsPosition()) {
                landsForIt = true;
                copter.change(CopterMode.LAND);
                copter.sendText(TextSeverity.CRITICAL, "EKF Failsafe: changed to LAND Mode");
            }
        } else if (has && positionLost) {
            positionLost = false;
            if (landsForIt) {
                landsForIt = false;
                copter.sendText(TextSeverity.CRITICAL, "EKF Failsafe Cleared");
            }
        }
    }

    /** FENCE_ACTION 0 tells, 2 lands, 4 brakes, all others return; far outside it lands whatever was asked for. */
    private void checkFence(long nowMillis) {
        if (!copter.fence().check(nowMillis) || !craft.armed()) {
            return;
        }
        int action = (int) copter.parameters().value("FENCE_ACTION");
        if (craft.landed()) {
            if (action != 0) {
                copter.disarm(true);
            }
            return;
        }
        copter.sendText(TextSeverity.NOTICE, "Fence Breached");
        if (action == 0) {
            return;
        }
        CopterMode wanted = action == 4 ? CopterMode.BRAKE : CopterMode.RTL;
        if (action == 2 || copter.fence().metersOutside() > GIVE_UP_METERS || !copter.change(wanted)) {
            copter.change(CopterMode.LAND);
        }
    }

    private void checkMotors(long nowMillis) {
        if (!craft.motorFailed() || !craft.armed()) {
            motorFailedAt = -1;
            thrustLossReported = false;
            return;
        }
        if (motorFailedAt < 0) {
            motorFailedAt = nowMillis;
        }
        if (!thrustLossReported && nowMillis - motorFailedAt >= THRUST_LOSS_MILLIS) {
            thrustLossReported = true;
            copter.sendText(TextSeverity.EMERGENCY, "Potential Thrust Loss (1)");
        }
    }
}
