package org.dronemap.sim.autopilot;

import java.util.Arrays;
import org.dronemap.mavlink.message.BatteryStatus;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedParameters;

/**
 * BATTERY_STATUS of a simulated vehicle: of one battery, or of two in turn, as ArduPilot sends them. Cells are told one
 * by one when it has been told how many there are. Owned by its vehicle.
 */
public final class BatteryReports {
    private static final int UNKNOWN_CELL = 0xFFFF;
    private static final int FIRST_CELLS = 10;
    private static final int MORE_CELLS = 4;
    private static final int MAX_CELLS = FIRST_CELLS + MORE_CELLS;
    private static final int LOW_PERCENT = 15;
    private static final int CRITICAL_PERCENT = 7;

    private final SimulatedCraft craft;
    private final SimulatedParameters parameters;
    private int cells;
    private boolean unknown;
    private boolean secondIsNext;

    BatteryReports(SimulatedAutopilot autopilot) {
        this.craft = autopilot.craft();
        this.parameters = autopilot.parameters();
    }

    /** So many cells are told one by one; 0: their sum alone. */
    public void setCells(int count) {
        if (count < 0 || count > MAX_CELLS) {
            throw new IllegalArgumentException(count + " cells are not within 0 to " + MAX_CELLS);
        }
        cells = count;
    }

    /** The monitor has stopped measuring, and says so. */
    public void setUnknown(boolean on) {
        unknown = on;
    }

    double volts() {
        SimulatedParameters.Parameter forced = parameters.find("SIM_BATT_VOLTAGE");
        return forced != null && forced.value() > 0
                ? forced.value()
                : craft.battery().volts();
    }

    int percent() {
        return (int) Math.round(Math.max(0, craft.battery().remainingPercent()));
    }

    /** What SYS_STATUS has of them: millivolts, hundredths of amperes and percent, or that it does not know. */
    int millivolts() {
        return unknown ? UNKNOWN_CELL : (int) Math.round(volts() * 1000);
    }

    int centiamperes() {
        return unknown ? -1 : (int) Math.round(craft.battery().amps() * 100);
    }

    int percentOrUnknown() {
        return unknown ? -1 : percent();
    }

    BatteryStatus next() {
        SimulatedParameters.Parameter monitor = parameters.find("BATT2_MONITOR");
        boolean second = monitor != null && monitor.value() != 0 && !secondIsNext;
        secondIsNext = second;
        return status(second ? 1 : 0);
    }

    private BatteryStatus status(int id) {
        int consumed = (int) Math.round(craft.battery().consumedMilliampHours());
        int chargeState = percent() > LOW_PERCENT ? 1 : percent() > CRITICAL_PERCENT ? 2 : 3;
        return new BatteryStatus(
                id,
                0,
                1,
                Short.MAX_VALUE,
                firstCells(),
                centiamperes(),
                unknown ? -1 : consumed,
                -1,
                percentOrUnknown(),
                0,
                unknown ? 0 : chargeState,
                moreCells(),
                0,
                0);
    }

    private int[] firstCells() {
        int[] told = new int[FIRST_CELLS];
        Arrays.fill(told, UNKNOWN_CELL);
        if (!unknown) {
            Arrays.fill(told, 0, Math.max(1, Math.min(cells, FIRST_CELLS)), cell());
        }
        return told;
    }

    /** Those beyond the tenth; there 0 means that there is none. */
    private int[] moreCells() {
        int[] told = new int[MORE_CELLS];
        if (!unknown && cells > FIRST_CELLS) {
            Arrays.fill(told, 0, cells - FIRST_CELLS, cell());
        }
        return told;
    }

    private int cell() {
        return (int) Math.round(volts() * 1000 / Math.max(1, cells));
    }
}
