package org.dronemap.cognitive.allocate;

import java.util.SplittableRandom;
import java.util.function.Consumer;

/** One simulated-annealing search over plans by ruin and recreate. Owned by the thread that runs it. */
final class AnnealingSearch {
    private static final int BETWEEN_LOOKS = 64;
    /** Smaller gains are told of with the next larger one, or in the end. */
    private static final double WORTH_TELLING = 1e-4;

    private static final double ROUNDING = 1e-12;
    private static final int BETWEEN_SURVEYS = 64 * 256;
    private static final int MOST_RECONNECTIONS = 4;

    private final SearchContext ground;
    private final SplittableRandom random;
    private final TourLists tours;
    private final SearchCost worth;
    private final GreedyInsertion insertion;
    private final StringRemoval removal;
    private final TwoOptMove reconnection;
    private final CoolingSchedule cooling;
    private final double cooled;
    /** Before each ruin: long tours have more of them to find. */
    private final int reconnections;

    private int[][] best;
    private double bestExact;
    /** The tours are better than {@code best} says. */
    private boolean atBest;

    private double toldExact = Double.POSITIVE_INFINITY;
    private long iterations;

    /**
     * From tours at hand, what they leave out put in first.
     *
     * @param cooled how cool it begins: 0 as hot as from nothing, 1 cold
     * @param done iterations of searches before, counted on from there
     */
    AnnealingSearch(SearchContext ground, long seed, int[][] orders, double cooled, long done) {
        this.ground = ground;
        this.cooled = cooled;
        iterations = done;
        random = new SplittableRandom(seed);
        tours = ground.tours();
        worth = ground.worth(tours);
        insertion = new GreedyInsertion(tours, worth, ground.costs(), ground.near(), random);
        removal = new StringRemoval(
                tours, ground.near(), random, ground.instance().aim().longestWeight() > 0);
        reconnection = new TwoOptMove(tours, worth, ground.costs(), ground.near(), random);
        reconnections = Math.max(1, Math.min(MOST_RECONNECTIONS, tours.waypoints / tours.drones / 100));
        tours.set(orders);
        worth.rescale();
        worth.current();
        insertion.insertAll();
        tours.commit();
        if (ExactSearch.suits(tours)) {
            tours.set(ExactSearch.best(tours, ground.costs(), worth));
        }
        best = tours.orders();
        bestExact = worth.exact();
        cooling = CoolingSchedule.of(ground.instance(), tours.total());
    }

    Allocation run(SearchBudget budget, Consumer<Allocation> improved) {
        publish(improved);
        double current = worth.current();
        double heat = 0;
        while (!ExactSearch.suits(tours)) {
            if (iterations % BETWEEN_LOOKS == 0) {
                publish(improved);
                double used = budget.used(iterations);
                if (used >= 1) {
                    break;
                }
                heat = cooling.heat(cooled + (1 - cooled) * used);
                current = rescale();
            }
            iterations++;
            current = step(current, heat);
        }
        return allocation();
    }

    private void publish(Consumer<Allocation> improved) {
        if (bestExact < toldExact - WORTH_TELLING * Math.abs(toldExact) || Double.isInfinite(toldExact)) {
            toldExact = bestExact;
            improved.accept(allocation());
        }
    }

    private double rescale() {
        if (iterations % BETWEEN_SURVEYS == 0) {
            tours.surveyAll();
        }
        worth.rescale();
        return worth.current();
    }

    /** What it changes stays so; not while the tours are the only copy of the best ones. */
    private double reconnect(double start, double heat) {
        double current = start;
        for (int left = reconnections; left > 0 && !atBest; left--) {
            double now = reconnection.tryOne(current, current - heat * Math.log(random.nextDouble()));
            if (now != current) {
                current = now;
                tours.commit();
                noteIfBest();
            }
        }
        return current;
    }

    private double step(double start, double heat) {
        double current = reconnect(start, heat);
        removal.remove();
        insertion.insertAbsent();
        double candidate = worth.current();
        if (candidate >= current - heat * Math.log(random.nextDouble())) {
            tours.rollback();
            return current;
        }
        boolean better = isBest();
        if (!better && atBest) {
            // Copied when it is left, not each time that it gets better; the step away is given up for that.
            tours.rollback();
            best = tours.orders();
            atBest = false;
            return current;
        }
        tours.commit();
        noteIfBest();
        return candidate;
    }

    private boolean isBest() {
        return worth.exact() < bestExact - ROUNDING * Math.abs(bestExact);
    }

    private void noteIfBest() {
        if (isBest()) {
            bestExact = worth.exact();
            atBest = true;
        }
    }

    private Allocation allocation() {
        if (atBest) {
            best = tours.orders();
            atBest = false;
        }
        return Allocation.of(ground.instance(), ground.costs(), best, iterations);
    }
}
