package org.dronemap.sim.autopilot.ardupilot;

import java.util.Locale;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedParameters;
import org.jspecify.annotations.Nullable;

/** The battery fail-safe of a simulated ArduPilot vehicle: low and critical each trip once, after BATT_LOW_TIMER seconds. */
public final class BatteryFailsafe {
    /** A tripped battery fail-safe and its action, which each vehicle numbers in its own way; 0 only warns. */
    public record Trip(String text, int action) {}

    private final SimulatedCraft craft;
    private final SimulatedParameters parameters;
    private long lowSince = -1;
    private long criticalSince = -1;
    private boolean low;
    private boolean critical;

    public BatteryFailsafe(SimulatedCraft craft, SimulatedParameters parameters) {
        this.craft = craft;
        this.parameters = parameters;
    }

    public double volts() {
        double forced = parameters.value("SIM_BATT_VOLTAGE");
        return forced > 0 ? forced : craft.battery().volts();
    }

    public boolean tripped() {
        return low || critical;
    }

    /** The voltage has been set from outside: what is low is counted from now. */
    public void restartTimers() {
        lowSince = -1;
        criticalSince = -1;
    }

    void reset() {
        low = false;
        critical = false;
        lowSince = -1;
        criticalSince = -1;
    }

    @Nullable
    Trip check(long nowMillis) {
        long delay = (long) (parameters.value("BATT_LOW_TIMER") * 1000);
        criticalSince = since(criticalSince, isBelow("BATT_CRT_VOLT", "BATT_CRT_MAH"), nowMillis);
        lowSince = since(lowSince, isBelow("BATT_LOW_VOLT", "BATT_LOW_MAH"), nowMillis);
        if (!critical && criticalSince >= 0 && nowMillis - criticalSince >= delay) {
            critical = true;
            low = true;
            return new Trip(text("critical"), (int) parameters.value("BATT_FS_CRT_ACT"));
        }
        if (!low && lowSince >= 0 && nowMillis - lowSince >= delay) {
            low = true;
            return new Trip(text("low"), (int) parameters.value("BATT_FS_LOW_ACT"));
        }
        return null;
    }

    private static long since(long started, boolean below, long nowMillis) {
        if (!below) {
            return -1;
        }
        return started < 0 ? nowMillis : started;
    }

    private boolean isBelow(String voltsName, String remainingName) {
        double left = craft.battery().capacityMilliampHours() - craft.battery().consumedMilliampHours();
        return volts() < parameters.value(voltsName) || left < parameters.value(remainingName);
    }

    private String text(String kind) {
        return String.format(
                Locale.ROOT,
                "Battery 1 is %s %.2fV used %.0f mAh",
                kind,
                volts(),
                craft.battery().consumedMilliampHours());
    }
}
