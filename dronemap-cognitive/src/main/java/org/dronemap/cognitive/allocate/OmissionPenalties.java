package org.dronemap.cognitive.allocate;

import org.dronemap.cognitive.cost.AllocationObjective;
import org.dronemap.cognitive.cost.AllocationProblem;

/**
 * Penalties for waypoints that a plan leaves out, so high that leaving one out never pays. Immutable, safe for several
 * threads.
 */
final class OmissionPenalties {
    private final double most;
    private final double[] leftOut;

    OmissionPenalties(AllocationProblem instance, LegCosts costs) {
        most = 10 * worstPlan(instance, costs);
        double least = Double.POSITIVE_INFINITY;
        leftOut = new double[instance.visits().size()];
        for (int waypoint = 0; waypoint < leftOut.length; waypoint++) {
            leftOut[waypoint] = instance.visits().get(waypoint).priority();
            least = Math.min(least, leftOut[waypoint]);
        }
        for (int waypoint = 0; waypoint < leftOut.length; waypoint++) {
            leftOut[waypoint] *= most / least;
        }
    }

    /** What a plan costs that calls at each waypoint by itself, by the drone that is worst for it. */
    private static double worstPlan(AllocationProblem instance, LegCosts costs) {
        AllocationObjective aim = instance.aim();
        int drones = instance.carriers().size();
        double sumWeight = SearchCost.sumWeight(aim, drones);
        double all = 1;
        for (int waypoint = 0; waypoint < instance.visits().size(); waypoint++) {
            double worst = 0;
            for (int r = 0; r < drones; r++) {
                int start = instance.start(r);
                int end = instance.end(r);
                double alone = costs.seconds(r, start, waypoint) + costs.seconds(r, waypoint, end);
                double its = aim.longestWeight() * alone
                        + sumWeight * (costs.sumOf(r, start, waypoint, alone) + costs.sumOf(r, waypoint, end, alone));
                worst = Double.isFinite(its) ? Math.max(worst, its) : worst;
            }
            all += worst;
        }
        return all;
    }

    /** More than any plan costs. */
    double most() {
        return most;
    }

    double leftOut(int waypoint) {
        return leftOut[waypoint];
    }
}
