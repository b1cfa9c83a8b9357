package org.dronemap.cognitive.allocate;

import java.util.BitSet;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import org.dronemap.cognitive.cost.Instance;
import org.jspecify.annotations.Nullable;

/**
 * Allocates waypoints to drones and orders them: ruin and recreate under simulated annealing, from a plan at hand or from
 * none. The best plan so far is there at any time. Safe for several threads: each search has its own state.
 */
public final class Allocator {
    private static final int BETWEEN_LOOKS = 64;
    /** Smaller gains are told of with the next larger one, or in the end. */
    private static final double WORTH_TELLING = 1e-4;

    private static final double ROUNDING = 1e-12;
    private static final int BETWEEN_SURVEYS = 64 * 256;
    private static final int MOST_RECONNECTIONS = 4;

    private final Instance instance;
    private final Costs costs;
    private final Stakes stakes;
    private final Neighbours near;

    public Allocator(Instance instance) {
        this.instance = instance;
        costs = new Costs(instance);
        stakes = new Stakes(instance, costs);
        near = new Neighbours(instance.legs(), instance.visits().size());
    }

    /** A search from nothing; {@code improved} hears of every better plan, on this thread. */
    public Allocation search(long seed, Budget budget, Consumer<Allocation> improved) {
        return new Search(seed, null).run(budget, improved);
    }

    /** A search that begins with tours at hand; what they cannot serve any more, and waypoints in none of them, are put in first. */
    public Allocation improve(int[][] orders, long seed, Budget budget, Consumer<Allocation> improved) {
        return new Search(seed, orders).run(budget, improved);
    }

    /**
     * Tours at hand as they are, but for what they cannot serve any more, with all other waypoints put where they cost least,
     * the cheapest first. Quick: nothing is tried twice.
     *
     * @param closed drones that get nothing more
     */
    public Allocation insert(int[][] orders, BitSet closed) {
        Tours tours = new Tours(instance, costs);
        tours.set(new Mending(instance, costs).flyable(orders));
        Worth worth = new Worth(tours, costs, instance.aim(), stakes);
        new OrphanInsertion(tours, worth, costs, instance, near).insertAll(closed);
        return Allocation.of(instance, costs, tours.orders(), 0);
    }

    /** What a plan is compared by; less is better. */
    double worth(Allocation allocation) {
        Tours tours = new Tours(instance, costs);
        tours.set(allocation.orders());
        return new Worth(tours, costs, instance.aim(), stakes).exact();
    }

    /** One walk through the plans. */
    private final class Search {
        private final SplittableRandom random;
        private final Tours tours = new Tours(instance, costs);
        private final Worth worth = new Worth(tours, costs, instance.aim(), stakes);
        private final GreedyInsertion insertion;
        private final StringRemoval removal;
        private final Reconnection reconnection;
        private final Cooling cooling;
        /** Before each ruin: long tours have more of them to find. */
        private final int reconnections =
                Math.max(1, Math.min(MOST_RECONNECTIONS, tours.waypoints / tours.drones / 100));

        private int[][] best;
        private double bestExact;
        /** The tours are better than {@code best} says. */
        private boolean atBest;

        private double toldExact = Double.POSITIVE_INFINITY;
        private long iterations;

        Search(long seed, int @Nullable [][] orders) {
            random = new SplittableRandom(seed);
            insertion = new GreedyInsertion(tours, worth, costs, near, random);
            removal = new StringRemoval(tours, near, random);
            reconnection = new Reconnection(tours, worth, costs, near, random);
            if (orders != null) {
                tours.set(new Mending(instance, costs).flyable(orders));
            }
            worth.rescale();
            worth.now();
            insertion.insertAll();
            tours.keep();
            if (ExactSearch.suits(tours)) {
                tours.set(ExactSearch.best(tours, costs, worth));
            }
            best = tours.orders();
            bestExact = worth.exact();
            cooling = Cooling.of(instance, tours.total());
        }

        Allocation run(Budget budget, Consumer<Allocation> improved) {
            tell(improved);
            double current = worth.now();
            double heat = 0;
            while (!ExactSearch.suits(tours)) {
                if (iterations % BETWEEN_LOOKS == 0) {
                    tell(improved);
                    double used = budget.used(iterations);
                    if (used >= 1) {
                        break;
                    }
                    heat = cooling.heat(used);
                    current = lookAnew();
                }
                iterations++;
                current = step(current, heat);
            }
            return allocation();
        }

        private void tell(Consumer<Allocation> improved) {
            if (bestExact < toldExact - WORTH_TELLING * Math.abs(toldExact) || Double.isInfinite(toldExact)) {
                toldExact = bestExact;
                improved.accept(allocation());
            }
        }

        private double lookAnew() {
            if (iterations % BETWEEN_SURVEYS == 0) {
                tours.surveyAll();
            }
            worth.rescale();
            return worth.now();
        }

        /** What it changes stays so; not while the tours are the only copy of the best ones. */
        private double reconnect(double start, double heat) {
            double current = start;
            for (int left = reconnections; left > 0 && !atBest; left--) {
                double now = reconnection.tryOne(current, current - heat * Math.log(random.nextDouble()));
                if (now != current) {
                    current = now;
                    tours.keep();
                    noteIfBest();
                }
            }
            return current;
        }

        private double step(double start, double heat) {
            double current = reconnect(start, heat);
            removal.remove();
            insertion.insertAbsent();
            double candidate = worth.now();
            if (candidate >= current - heat * Math.log(random.nextDouble())) {
                tours.takeBack();
                return current;
            }
            boolean better = isBest();
            if (!better && atBest) {
                // Copied when it is left, not each time that it gets better; the step away is given up for that.
                tours.takeBack();
                best = tours.orders();
                atBest = false;
                return current;
            }
            tours.keep();
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
            return Allocation.of(instance, costs, best, iterations);
        }
    }
}
