package org.dronemap.sim.physics;

/**
 * The battery of a simulated vehicle: a three-cell pack drained by flight, in volts, amperes and mAh. Owned by its
 * vehicle.
 */
public final class BatteryModel {
    private static final double HOVER_AMPS = 14;
    private static final double IDLE_AMPS = 2;
    private static final double AVIONICS_AMPS = 0.05;
    private static final double INTERNAL_OHMS = 0.012;
    private static final double[] OPEN_CIRCUIT_VOLTS = {
        9.6, 10.6, 10.9, 11.1, 11.25, 11.4, 11.55, 11.75, 12.0, 12.3, 12.6
    };

    private final double capacityMilliampHours;
    private double consumedMilliampHours;
    private double spentMilliampHours;
    private double amps = AVIONICS_AMPS;

    public BatteryModel(double capacityMilliampHours) {
        this.capacityMilliampHours = capacityMilliampHours;
    }

    /**
     * Draws current for that long.
     *
     * @param thrust share of the hovering thrust, 0 when the motors stand
     */
    public void step(boolean armed, double thrust, double seconds) {
        double motors = armed ? Math.max(IDLE_AMPS, HOVER_AMPS * Math.pow(thrust, 1.5)) : 0;
        amps = isEmpty() ? 0 : AVIONICS_AMPS + motors;
        double drained = amps * seconds / 3.6;
        consumedMilliampHours = Math.min(capacityMilliampHours, consumedMilliampHours + drained);
        spentMilliampHours += drained;
    }

    /** Swaps the pack for one with this much left. */
    public void setRemainingPercent(double percent) {
        consumedMilliampHours = capacityMilliampHours * (1 - percent / 100);
    }

    public double remainingPercent() {
        return 100 * (1 - consumedMilliampHours / capacityMilliampHours);
    }

    public boolean isEmpty() {
        return consumedMilliampHours >= capacityMilliampHours;
    }

    public double volts() {
        double steps = remainingPercent() / 10;
        int lower = Math.min(9, (int) steps);
        double open = OPEN_CIRCUIT_VOLTS[lower]
                + (steps - lower) * (OPEN_CIRCUIT_VOLTS[lower + 1] - OPEN_CIRCUIT_VOLTS[lower]);
        return open - amps * INTERNAL_OHMS;
    }

    public double amps() {
        return amps;
    }

    /** Out of the present pack since it was full. */
    public double consumedMilliampHours() {
        return consumedMilliampHours;
    }

    /** Really drawn since power-up, whatever pack was in. */
    public double spentMilliampHours() {
        return spentMilliampHours;
    }

    public double capacityMilliampHours() {
        return capacityMilliampHours;
    }
}
