package org.dronemap.cognitive.engine;

import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.dronemap.cognitive.allocate.Allocation;
import org.dronemap.cognitive.allocate.Allocator;
import org.dronemap.cognitive.allocate.LowerBound;
import org.dronemap.cognitive.allocate.SearchBudget;
import org.dronemap.cognitive.cost.AllocationObjective;
import org.dronemap.cognitive.cost.CostModel;
import org.dronemap.cognitive.plan.Plan;
import org.dronemap.cognitive.plan.PlanChecker;
import org.dronemap.cognitive.plan.PlanDeconflicter;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.replan.ReplanSituation;
import org.dronemap.cognitive.replan.Replanner;

/**
 * Plans the tours of several drones: allocates waypoints, and keeps the drones apart in time and height. Every plan
 * that leaves here was looked at by the independent checker.
 */
public final class FleetPlanner {
    /** Work for the bound, in legs looked at: a few hundredths of a second. */
    private static final long BOUND_LEGS = 4_000_000;

    private static final int MOST_BOUND_ROUNDS = 200;

    private FleetPlanner() {}

    /**
     * Searches until the budget is spent.
     *
     * @param seed the same one gives the same plan for a budget of iterations
     * @param progress hears of better plans, on this thread
     */
    public static PlanResult plan(
            PlanningProblem problem, long seed, SearchBudget budget, Consumer<SearchProgress> progress) {
        return planObserved(problem, seed, budget, (better, orders) -> progress.accept(better));
    }

    /**
     * The same.
     *
     * @param watcher hears of better plans, on this thread, and for each drone of the numbers of its waypoints in order
     */
    public static PlanResult planObserved(
            PlanningProblem problem, long seed, SearchBudget budget, BiConsumer<SearchProgress, int[][]> watcher) {
        CostModel costs = CostModel.of(problem);
        AllocationObjective aim = costs.instance().aim();
        double bound = LowerBound.of(costs.instance(), boundRounds(problem));
        Allocation found = new Allocator(costs.instance())
                .search(seed, budget, better -> watcher.accept(progress(better, aim, bound), better.orders()));
        Plan apart =
                PlanDeconflicter.deconflict(problem, costs.plan(found.orders())).plan();
        return new PlanResult(apart, progress(found, aim, bound), PlanChecker.faults(problem, apart));
    }

    /** The first drone visits what it can in the order of the list: nothing is searched, and nothing checked. */
    public static Plan asListed(PlanningProblem problem) {
        CostModel costs = CostModel.of(problem);
        int[][] orders = new int[problem.crafts().size()][0];
        orders[0] = IntStream.range(0, problem.waypoints().size())
                .filter(waypoint ->
                        costs.instance().visits().get(waypoint).drones().get(0))
                .toArray();
        return costs.plan(orders);
    }

    /** Plans anew from a plan that is being flown: at once, and better within a budget. */
    public static Replanner replanning(ReplanSituation situation) {
        return new Replanner(situation);
    }

    private static int boundRounds(PlanningProblem problem) {
        long legs = Math.max(
                1, (long) problem.waypoints().size() * problem.waypoints().size());
        return (int) Math.min(MOST_BOUND_ROUNDS, BOUND_LEGS / legs);
    }

    private static SearchProgress progress(Allocation found, AllocationObjective aim, double bound) {
        double cost = aim.longestWeight() * found.longestSeconds() + aim.sumWeight() * found.sum();
        int unserved = found.unserved().length;
        double gap = unserved > 0 ? 1 : cost > 0 ? Math.max(0, 1 - bound / cost) : 0;
        return new SearchProgress(found.longestSeconds(), found.sum(), unserved, gap, found.iterations());
    }
}
