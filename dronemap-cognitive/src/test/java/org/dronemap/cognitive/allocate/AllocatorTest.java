package org.dronemap.cognitive.allocate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import org.dronemap.cognitive.cost.AllocationObjective;
import org.dronemap.cognitive.cost.AllocationProblem;
import org.junit.jupiter.api.Test;

/** Plans that can be flown, the best ones where all can be tried, and the same ones for the same seed. */
class AllocatorTest {
    private static final SearchBudget SHORT = SearchBudget.iterations(3_000);

    private final RandomAllocationProblems instances = new RandomAllocationProblems(1);

    private static Allocation search(AllocationProblem instance, long seed, SearchBudget budget) {
        return new Allocator(instance).search(seed, budget, better -> {});
    }

    @Test
    void findsTheBestOfAllPlansOfTinyProblems() {
        for (int problem = 0; problem < 1_000; problem++) {
            AllocationProblem instance = instances.any(1 + problem % 5, 1 + problem % 3);
            Allocation found = search(instance, problem, SHORT);

            AllocationOracle judge = new AllocationOracle(instance);
            assertThat(judge.faults(found.orders())).as("problem %d", problem).isEmpty();
            assertThat(judge.verdict(found.orders()).isWorseThan(BruteForcePlans.best(instance)))
                    .as(
                            "problem %d: %s against %s",
                            problem, judge.verdict(found.orders()), BruteForcePlans.best(instance))
                    .isFalse();
        }
    }

    @Test
    void boundsTheBestPlanFromBelow() {
        int close = 0;
        for (int problem = 0; problem < 1_000; problem++) {
            AllocationProblem instance = instances.any(1 + problem % 5, 1 + problem % 3);
            AllocationOracle.Expectation best = BruteForcePlans.best(instance);
            if (best.leftOut() > 0) {
                continue;
            }
            double bound = LowerBound.of(instance, 50);

            assertThat(bound).as("problem %d", problem).isLessThanOrEqualTo(best.aim() * (1 + 1e-9) + 1e-9);
            close += bound > best.aim() / 2 ? 1 : 0;
        }
        assertThat(close).isGreaterThan(200);
    }

    @Test
    void comesWithinAFewPercentOfItsBoundOnATourOfOneDrone() {
        AllocationProblem instance =
                instances.plain(60, 1, AllocationObjective.minSum(AllocationObjective.Measure.METERS));

        Allocation found = search(instance, 1, SearchBudget.iterations(30_000));

        assertThat(found.sum()).isBetween(LowerBound.of(instance, 300), 1.03 * LowerBound.of(instance, 300));
    }

    @Test
    void keepsToWindowsBatteriesAndSkillsOfLargerProblems() {
        for (int problem = 0; problem < 60; problem++) {
            AllocationProblem instance = instances.any(25, 1 + problem % 4);
            Allocation found = search(instance, problem, SHORT);

            assertThat(new AllocationOracle(instance).faults(found.orders()))
                    .as("problem %d", problem)
                    .isEmpty();
            int served = Arrays.stream(found.orders())
                    .mapToInt(order -> order.length)
                    .sum();
            assertThat(served + found.unserved().length).isEqualTo(25);
        }
    }

    @Test
    void isNearlyAsGoodAsTryingEverythingWhereItDoesNotTryEverything() {
        double gaps = 0;
        for (int problem = 0; problem < 10; problem++) {
            AllocationProblem instance = instances.any(6, 6);
            Allocation found = search(instance, problem, SHORT);
            AllocationOracle.Expectation best = BruteForcePlans.best(instance);
            AllocationOracle.Expectation verdict = new AllocationOracle(instance).verdict(found.orders());

            assertThat(best.isWorseThan(verdict)).as("problem %d", problem).isFalse();
            assertThat(verdict.leftOut()).as("problem %d", problem).isEqualTo(best.leftOut());
            gaps += verdict.aim() / best.aim() - 1;
        }
        assertThat(gaps / 10).isLessThan(0.05);
    }

    @Test
    void tellsTheSameTimesAsAnIndependentJudge() {
        AllocationProblem instance = instances.plain(80, 4, AllocationObjective.minMax());
        Allocation found = search(instance, 3, SHORT);

        assertThat(found.longestSeconds())
                .isCloseTo(
                        new AllocationOracle(instance).verdict(found.orders()).longest(), offset(1e-6));
    }

    @Test
    void findsTheSamePlanForTheSameSeed() {
        AllocationProblem instance = instances.plain(80, 4, AllocationObjective.minMax());

        assertThat(search(instance, 7, SHORT).orders())
                .isDeepEqualTo(search(instance, 7, SHORT).orders());
    }

    @Test
    void tellsOfEachBetterPlanUntilItIsCancelled() {
        AllocationProblem instance = instances.plain(80, 4, AllocationObjective.minMax());
        List<Double> heard = new ArrayList<>();
        AtomicBoolean cancelled = new AtomicBoolean();
        SearchBudget budget = SearchBudget.iterations(1_000_000).orWhen(cancelled::get);

        Allocation found = new Allocator(instance).search(1, budget, better -> {
            heard.add(better.longestSeconds());
            cancelled.set(heard.size() == 5);
        });

        assertThat(heard).hasSize(5).isSortedAccordingTo((one, other) -> Double.compare(other, one));
        assertThat(found.longestSeconds()).isLessThanOrEqualTo(heard.get(4));
    }

    @Test
    void neverMakesAPlanAtHandWorse() {
        AllocationProblem instance = instances.plain(80, 4, AllocationObjective.minMax());
        int[][] good = search(instance, 1, SearchBudget.iterations(20_000)).orders();
        double before = new AllocationOracle(instance).verdict(good).aim();

        Allocation found = new Allocator(instance).improve(good, 2, SHORT, better -> {});

        assertThat(new AllocationOracle(instance).verdict(found.orders()).aim()).isLessThanOrEqualTo(before + 1e-9);
    }

    @Test
    void putsOrphansIntoThePlanAtHand() {
        AllocationProblem instance = instances.plain(40, 3, AllocationObjective.minMax());
        int[][] orders = search(instance, 1, SHORT).orders();
        orders[0] = new int[0];

        Allocation found = new Allocator(instance).improve(orders, 1, SearchBudget.iterations(1), better -> {});

        assertThat(found.unserved()).isEmpty();
    }

    @Test
    void answersAProblemWithoutWaypoints() {
        Allocation found = search(instances.plain(0, 2, AllocationObjective.minMax()), 1, SHORT);

        assertThat(found.orders()).hasDimensions(2, 0);
        assertThat(found.longestSeconds()).isZero();
    }
}
