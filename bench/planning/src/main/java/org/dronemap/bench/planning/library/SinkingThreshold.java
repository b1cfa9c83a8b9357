package org.dronemap.bench.planning.library;

import com.graphhopper.jsprit.core.algorithm.acceptor.SolutionAcceptor;
import com.graphhopper.jsprit.core.problem.solution.VehicleRoutingProblemSolution;
import java.util.Collection;
import org.dronemap.bench.planning.CpuBudget;

/** Takes what is not worse than the last one by more than a threshold, which sinks to nearly nothing as the CPU is used up. */
final class SinkingThreshold implements SolutionAcceptor {
    private static final double FIRST = 0.02;
    private static final double LAST = 0.0001;

    private final CpuBudget allowance;

    SinkingThreshold(CpuBudget allowance) {
        this.allowance = allowance;
    }

    @Override
    public boolean acceptSolution(
            Collection<VehicleRoutingProblemSolution> solutions, VehicleRoutingProblemSolution candidate) {
        double most = 1 + FIRST * Math.pow(LAST / FIRST, Math.min(1, allowance.share()));
        boolean accepted = solutions.isEmpty()
                || candidate.getCost() < most * solutions.iterator().next().getCost();
        if (accepted) {
            solutions.clear();
            solutions.add(candidate);
        }
        return accepted;
    }
}
