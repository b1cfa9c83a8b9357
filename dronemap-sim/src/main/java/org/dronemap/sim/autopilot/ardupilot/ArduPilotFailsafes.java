package org.dronemap.sim.autopilot.ardupilot;

import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.TextSeverity;

/** The fail-safes of a simulated ArduPilot vehicle: when they trip is alike, what follows is each vehicle's own. */
public abstract class ArduPilotFailsafes {
    private static final long NEVER = -1;

    private final SimulatedArduPilot vehicle;
    private final SimulatedCraft craft;
    private final BatteryFailsafe battery;
    private long lastHeartbeatAt = NEVER;

    protected ArduPilotFailsafes(SimulatedArduPilot vehicle, BatteryFailsafe battery) {
        this.vehicle = vehicle;
        this.craft = vehicle.craft();
        this.battery = battery;
    }

    /** One of them lasts, which the heartbeat tells as a critical state. */
    public abstract boolean any();

    /** Looks after what this kind of vehicle watches beside its battery. */
    protected abstract void checkOwn(long nowMillis);

    /** The battery's fail-safe has tripped while it was armed; the battery's own sentence is said. */
    protected abstract void batteryFailed(int action);

    void heartbeatReceived(long nowMillis) {
        lastHeartbeatAt = nowMillis;
    }

    /** No heartbeat of the ground station came for so long; false as long as there has never been one. */
    protected boolean groundStationSilent(long nowMillis, double seconds) {
        return lastHeartbeatAt != NEVER && nowMillis - lastHeartbeatAt >= (long) (seconds * 1000);
    }

    void check(long nowMillis) {
        checkBattery(battery, nowMillis);
        checkBattery(vehicle.secondBattery(), nowMillis);
        checkOwn(nowMillis);
    }

    private void checkBattery(BatteryFailsafe failsafe, long nowMillis) {
        if (!craft.armed() && failsafe.isRecovered()) {
            failsafe.reset();
        }
        BatteryFailsafe.Trip trip = failsafe.check(nowMillis);
        if (trip == null) {
            return;
        }
        vehicle.sendText(TextSeverity.WARNING, trip.text());
        if (craft.armed()) {
            batteryFailed(trip.action());
        }
    }
}
