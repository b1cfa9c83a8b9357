package org.dronemap.cognitive.allocate;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;

/**
 * Runs several searches of one problem in parallel, each with its own seed and the whole budget, and takes the best
 * plan. Which one is found in a budget of iterations does not depend on how the searches share processors.
 */
public final class ParallelSearch {
    private static final long BETWEEN_SEEDS = 1_000_003;

    private final Allocator allocator;
    private final int searches;
    private final Executor executor;

    @FunctionalInterface
    private interface Search {
        Allocation run(long seed, SearchBudget budget, Consumer<Allocation> improved);
    }

    /** All searches but one run on the executor, which must start them at once; one runs on the thread that asks. */
    public ParallelSearch(Allocator allocator, int searches, Executor executor) {
        if (searches < 1) {
            throw new IllegalArgumentException("searches must be at least 1: " + searches);
        }
        this.allocator = allocator;
        this.searches = searches;
        this.executor = executor;
    }

    /** {@code improved} hears of every plan that is better than those of all searches before, one at a time on any thread. */
    public Allocation search(long seed, SearchBudget budget, Consumer<Allocation> improved) {
        return together(allocator::search, seed, budget, improved);
    }

    /** Searches that all begin with the same tours at hand; {@code improved} hears as in {@link #search}. */
    public Allocation improve(int[][] orders, long seed, SearchBudget budget, Consumer<Allocation> improved) {
        return together((its, whole, better) -> allocator.improve(orders, its, whole, better), seed, budget, improved);
    }

    private Allocation together(Search search, long seed, SearchBudget budget, Consumer<Allocation> improved) {
        AtomicBoolean failed = new AtomicBoolean();
        SearchBudget whole = budget.orWhen(failed::get);
        Incumbent best = new Incumbent(allocator::worth, improved);
        List<CompletableFuture<Allocation>> others = new ArrayList<>();
        for (int number = 1; number < searches; number++) {
            long its = seed + BETWEEN_SEEDS * number;
            others.add(CompletableFuture.supplyAsync(() -> guarded(search, its, whole, best, failed), executor));
        }
        List<Allocation> found = new ArrayList<>();
        found.add(guarded(search, seed, whole, best, failed));
        others.forEach(other -> found.add(other.join()));
        return least(found);
    }

    /** A search that fails ends the others. */
    private static Allocation guarded(
            Search search, long seed, SearchBudget budget, Incumbent best, AtomicBoolean failed) {
        boolean done = false;
        try {
            Allocation found = search.run(seed, budget, best::offer);
            done = true;
            return found;
        } finally {
            if (!done) {
                failed.set(true);
            }
        }
    }

    /** The first of equals. */
    private Allocation least(List<Allocation> found) {
        Allocation least = found.get(0);
        for (Allocation one : found) {
            least = allocator.worth(one) < allocator.worth(least) ? one : least;
        }
        return least;
    }
}
