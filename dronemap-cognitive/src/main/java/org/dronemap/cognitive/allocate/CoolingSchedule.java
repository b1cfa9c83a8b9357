package org.dronemap.cognitive.allocate;

import org.dronemap.cognitive.cost.AllocationProblem;

/** Exponential cooling schedule of the annealing search: its temperature for each share of the budget used. */
record CoolingSchedule(double hot, double cold) {
    /** In legs of mean length, shared by the drones where only the longest tour matters. */
    private static final double HOT = 5;

    private static final double COLD = 0.03;

    static CoolingSchedule of(AllocationProblem instance, double total) {
        int drones = instance.carriers().size();
        double leg = total / (instance.visits().size() + drones);
        double unit =
                instance.aim().longestWeight() * leg / drones + instance.aim().sumWeight() * leg;
        return new CoolingSchedule(unit * HOT, unit * COLD);
    }

    /** For a share of the budget, 0 to 1. */
    double heat(double used) {
        return hot * Math.pow(cold / hot, used);
    }
}
