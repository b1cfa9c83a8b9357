package org.dronemap.cognitive.allocate;

import java.util.BitSet;
import java.util.function.Consumer;
import org.dronemap.cognitive.cost.AllocationProblem;

/**
 * Allocates waypoints to drones and orders them by simulated annealing, from an existing plan or from none. The best
 * plan so far is there at any time. Safe for several threads: each search has its own state.
 */
public final class Allocator {
    private final SearchContext ground;

    public Allocator(AllocationProblem instance) {
        ground = SearchContext.of(instance);
    }

    /** A search from nothing; {@code improved} hears of every better plan, on this thread. */
    public Allocation search(long seed, SearchBudget budget, Consumer<Allocation> improved) {
        return new MultiStartSearch(ground).search(seed, budget, improved);
    }

    /** A search that begins with tours at hand; what they cannot serve any more, and waypoints in none of them, are put in first. */
    public Allocation improve(int[][] orders, long seed, SearchBudget budget, Consumer<Allocation> improved) {
        return new AnnealingSearch(ground, seed, flyable(orders), 0, 0).run(budget, improved);
    }

    /**
     * Tours at hand as they are, but for what they cannot serve any more, with all other waypoints put where they cost least,
     * the cheapest first. Quick: nothing is tried twice.
     *
     * @param closed drones that get nothing more
     */
    public Allocation insert(int[][] orders, BitSet closed) {
        TourLists tours = ground.tours();
        tours.set(flyable(orders));
        new OrphanInsertion(tours, ground.worth(tours), ground.costs(), ground.instance(), ground.near())
                .insertAll(closed);
        return Allocation.of(ground.instance(), ground.costs(), tours.orders(), 0);
    }

    private int[][] flyable(int[][] orders) {
        return new TourRepair(ground.instance(), ground.costs()).flyable(orders);
    }

    /** What a plan is compared by; less is better. */
    double worth(Allocation allocation) {
        return ground.worth(allocation);
    }
}
