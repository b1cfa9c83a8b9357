package org.dronemap.cognitive.allocate;

import java.util.function.Consumer;

/**
 * Runs a few short annealing searches from nothing, then a long and cooler one from the best plan that they found. What
 * a single walk settles early, as which base serves which cluster, it hardly ever undoes, and whether it was right is a
 * matter of luck.
 */
final class MultiStartSearch {
    private static final int WALKS = 4;
    /** Of the budget, for all of them. */
    private static final double SHARE = 0.4;

    private static final double COOLED = 0.35;
    /** More waypoints want the whole budget for one walk. */
    private static final int MOST_WAYPOINTS = 1_000;

    private static final long BETWEEN_SEEDS = 2_000_003;

    private final SearchContext ground;

    MultiStartSearch(SearchContext ground) {
        this.ground = ground;
    }

    Allocation search(long seed, SearchBudget budget, Consumer<Allocation> improved) {
        int[][] nothing = new int[ground.instance().carriers().size()][0];
        TourLists tours = ground.tours();
        if (tours.waypoints > MOST_WAYPOINTS || ExactSearch.suits(tours)) {
            return new AnnealingSearch(ground, seed, nothing, 0, 0).run(budget, improved);
        }
        Incumbent best = new Incumbent(ground::worth, improved);
        long done = 0;
        for (int walk = 0; walk < WALKS; walk++) {
            SearchBudget its = budget.part(SHARE * walk / WALKS, SHARE * (walk + 1) / WALKS);
            done = walk(seed + BETWEEN_SEEDS * walk, nothing, 0, done, its, best);
        }
        done = walk(seed, best.plan().orders(), COOLED, done, budget.part(SHARE, 1), best);
        return best.plan().after(done);
    }

    private long walk(long seed, int[][] orders, double cooled, long done, SearchBudget budget, Incumbent best) {
        Allocation found = new AnnealingSearch(ground, seed, orders, cooled, done).run(budget, best::offer);
        best.offer(found);
        return found.iterations();
    }
}
