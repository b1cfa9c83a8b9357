package org.dronemap.sim.autopilot.ardupilot;

import java.util.List;
import java.util.Locale;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedParameters;
import org.jspecify.annotations.Nullable;

/** The battery fail-safe of a simulated ArduPilot vehicle: low and critical each trip once, after BATT_LOW_TIMER seconds. */
public final class BatteryFailsafe {
    /** A tripped battery fail-safe and its action, which each vehicle numbers in its own way; 0 only warns. */
    public record Trip(String text, int action) {}

    private static final double RECOVERED_VOLTS = 0.3;

    private final SimulatedCraft craft;
    private final SimulatedParameters parameters;
    private final int number;
    private final String prefix;
    private long lowSince = -1;
    private long criticalSince = -1;
    private boolean low;
    private boolean critical;

    /** {@code number} counts from 1; beyond the first only with a monitor of its own. */
    public BatteryFailsafe(SimulatedCraft craft, SimulatedParameters parameters, int number) {
        this.craft = craft;
        this.parameters = parameters;
        this.number = number;
        this.prefix = number == 1 ? "BATT_" : "BATT" + number + "_";
    }

    private double value(String name) {
        return parameters.value(prefix + name);
    }

    /** What keeps it from arming; empty when nothing does. */
    public List<String> complaints() {
        if (!isMonitored()) {
            return List.of();
        }
        if (volts() < value("CRT_VOLT")) {
            return List.of("Battery " + number + " critical voltage failsafe");
        }
        return volts() < value("LOW_VOLT") || tripped()
                ? List.of("Battery " + number + " low voltage failsafe")
                : List.of();
    }

    private boolean isMonitored() {
        return number == 1 || value("MONITOR") != 0;
    }

    /** So much above its low voltage that it counts as another one. */
    boolean isRecovered() {
        return tripped() && volts() > value("LOW_VOLT") + RECOVERED_VOLTS;
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
        if (!isMonitored()) {
            return null;
        }
        long delay = (long) (value("LOW_TIMER") * 1000);
        criticalSince = since(criticalSince, isBelow("CRT_VOLT", "CRT_MAH"), nowMillis);
        lowSince = since(lowSince, isBelow("LOW_VOLT", "LOW_MAH"), nowMillis);
        if (!critical && criticalSince >= 0 && nowMillis - criticalSince >= delay) {
            critical = true;
            low = true;
            return new Trip(text("critical"), (int) value("FS_CRT_ACT"));
        }
        if (!low && lowSince >= 0 && nowMillis - lowSince >= delay) {
            low = true;
            return new Trip(text("low"), (int) value("FS_LOW_ACT"));
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
        return volts() < value(voltsName) || left < value(remainingName);
    }

    private String text(String kind) {
        return String.format(
                Locale.ROOT,
                "Battery %d is %s %.2fV used %.0f mAh",
                number,
                kind,
                volts(),
                craft.battery().consumedMilliampHours());
    }
}
