package org.dronemap.cognitive.replan;

import java.util.BitSet;
import java.util.concurrent.Executor;
import org.dronemap.cognitive.allocate.Allocation;
import org.dronemap.cognitive.allocate.Allocator;
import org.dronemap.cognitive.allocate.ParallelSearch;
import org.dronemap.cognitive.allocate.SearchBudget;
import org.dronemap.cognitive.cost.AllocationObjective;
import org.dronemap.cognitive.cost.CostModel;
import org.dronemap.cognitive.cost.RemainingProblem;
import org.dronemap.cognitive.plan.Plan;
import org.dronemap.cognitive.plan.PlanChecker;
import org.dronemap.cognitive.plan.PlanDeconflicter;
import org.dronemap.cognitive.problem.PlanningProblem;

/**
 * Plans tours anew while they are flown: at once by keeping most of them, or better within a search budget. Both were
 * looked at by the independent checker. Immutable, safe for several threads: the same situation, seed and number of
 * iterations give the same plan.
 */
public final class Replanner {
    private static final double SEARCH_SHARE = 0.9;

    private final PlanningProblem problem;
    private final CostModel costs;
    private final RemainingProblem continuation;
    private final Allocator allocator;
    private final IndexedAssignments standing;
    private final PlanFigures before;
    private final Allocation kept;

    public Replanner(ReplanSituation situation) {
        problem = situation.problem();
        costs = CostModel.of(problem);
        standing = IndexedAssignments.of(situation);
        continuation = RemainingProblem.of(costs.instance(), standing.firm());
        allocator = new Allocator(continuation.rest());
        int[][] live = continuation.rest(standing.orders());
        BitSet everybody = new BitSet();
        everybody.set(0, live.length);
        before = figures(allocator.insert(live, everybody));
        kept = insert(live);
    }

    /** Nothing is left undone only because those who could do it are busy. */
    private Allocation insert(int[][] live) {
        Allocation others = allocator.insert(live, standing.busy());
        if (standing.busy().isEmpty() || others.unserved().length == 0) {
            return others;
        }
        Allocation all = allocator.insert(live, new BitSet());
        return all.unserved().length < others.unserved().length ? all : others;
    }

    /** Live orders as they are, but for what cannot be flown any more, and orphans among them. */
    public ReplanResult atOnce() {
        return replanned(kept, 0);
    }

    /** On this thread alone. */
    public ReplanResult improve(long seed, SearchBudget budget) {
        return improve(seed, budget, 1, Runnable::run);
    }

    /**
     * Searches from there until the budget is spent, its last part on keeping drones from changing.
     *
     * @param searches at the same time, the best of which counts: one on this thread, the others on the executor
     */
    public ReplanResult improve(long seed, SearchBudget budget, int searches, Executor executor) {
        SearchBudget search = iterations -> budget.used(iterations) / SEARCH_SHARE;
        Allocation found =
                new ParallelSearch(allocator, searches, executor).improve(kept.orders(), seed, search, better -> {});
        int[][] live = continuation.rest(standing.orders());
        AssignmentRestoration restoring =
                new AssignmentRestoration(allocator, live, this::cost, () -> budget.used(0) >= 1);
        return replanned(restoring.fewestChanged(kept, found), found.iterations());
    }

    private double cost(Allocation allocation) {
        return figures(allocation).cost();
    }

    private PlanFigures figures(Allocation allocation) {
        AllocationObjective aim = continuation.whole().aim();
        double sum = allocation.sum() + continuation.sum();
        double cost = aim.longestWeight() * allocation.longestSeconds() + aim.sumWeight() * sum;
        return new PlanFigures(allocation.longestSeconds(), sum, cost, allocation.unserved().length);
    }

    private ReplanResult replanned(Allocation allocation, long iterations) {
        int[][] orders = continuation.whole(allocation.orders());
        Plan plan = PlanDeconflicter.deconflict(problem, costs.plan(orders)).plan();
        return new ReplanResult(
                plan,
                standing.changes(orders),
                before,
                figures(allocation),
                iterations,
                PlanChecker.faults(problem, plan));
    }
}
