package org.dronemap.cognitive.allocate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import org.dronemap.cognitive.cost.Aim;
import org.dronemap.cognitive.cost.Instance;
import org.junit.jupiter.api.Test;

/** Plans that can be flown, the best ones where all can be tried, and the same ones for the same seed. */
class AllocatorTest {
    private static final Budget SHORT = Budget.iterations(3_000);

    private final RandomInstances instances = new RandomInstances(1);

    private static Allocation search(Instance instance, long seed, Budget budget) {
        return new Allocator(instance).search(seed, budget, better -> {});
    }

    @Test
    void findsTheBestOfAllPlansOfTinyProblems() {
        for (int problem = 0; problem < 1_000; problem++) {
            Instance instance = instances.any(1 + problem % 5, 1 + problem % 3);
            Allocation found = search(instance, problem, SHORT);

            Judge judge = new Judge(instance);
            assertThat(judge.faults(found.orders())).as("problem %d", problem).isEmpty();
            assertThat(judge.verdict(found.orders()).isWorseThan(EveryPlan.best(instance)))
                    .as("problem %d: %s against %s", problem, judge.verdict(found.orders()), EveryPlan.best(instance))
                    .isFalse();
        }
    }

    @Test
    void boundsTheBestPlanFromBelow() {
        int close = 0;
        for (int problem = 0; problem < 1_000; problem++) {
            Instance instance = instances.any(1 + problem % 5, 1 + problem % 3);
            Judge.Verdict best = EveryPlan.best(instance);
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
        Instance instance = instances.plain(60, 1, Aim.minSum(Aim.Measure.METERS));

        Allocation found = search(instance, 1, Budget.iterations(30_000));

        assertThat(found.sum()).isBetween(LowerBound.of(instance, 300), 1.03 * LowerBound.of(instance, 300));
    }

    @Test
    void keepsToWindowsBatteriesAndSkillsOfLargerProblems() {
        for (int problem = 0; problem < 60; problem++) {
            Instance instance = instances.any(25, 1 + problem % 4);
            Allocation found = search(instance, problem, SHORT);

            assertThat(new Judge(instance).faults(found.orders()))
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
            Instance instance = instances.any(6, 6);
            Allocation found = search(instance, problem, SHORT);
            Judge.Verdict best = EveryPlan.best(instance);
            Judge.Verdict verdict = new Judge(instance).verdict(found.orders());

            assertThat(best.isWorseThan(verdict)).as("problem %d", problem).isFalse();
            assertThat(verdict.leftOut()).as("problem %d", problem).isEqualTo(best.leftOut());
            gaps += verdict.aim() / best.aim() - 1;
        }
        assertThat(gaps / 10).isLessThan(0.05);
    }

    @Test
    void tellsTheSameTimesAsAnIndependentJudge() {
        Instance instance = instances.plain(80, 4, Aim.minMax());
        Allocation found = search(instance, 3, SHORT);

        assertThat(found.longestSeconds())
                .isCloseTo(new Judge(instance).verdict(found.orders()).longest(), offset(1e-6));
    }

    @Test
    void findsTheSamePlanForTheSameSeed() {
        Instance instance = instances.plain(80, 4, Aim.minMax());

        assertThat(search(instance, 7, SHORT).orders())
                .isDeepEqualTo(search(instance, 7, SHORT).orders());
    }

    @Test
    void tellsOfEachBetterPlanUntilItIsCancelled() {
        Instance instance = instances.plain(80, 4, Aim.minMax());
        List<Double> heard = new ArrayList<>();
        AtomicBoolean cancelled = new AtomicBoolean();
        Budget budget = Budget.iterations(1_000_000).orWhen(cancelled::get);

        Allocation found = new Allocator(instance).search(1, budget, better -> {
            heard.add(better.longestSeconds());
            cancelled.set(heard.size() == 5);
        });

        assertThat(heard).hasSize(5).isSortedAccordingTo((one, other) -> Double.compare(other, one));
        assertThat(found.longestSeconds()).isLessThanOrEqualTo(heard.get(4));
    }

    @Test
    void neverMakesAPlanAtHandWorse() {
        Instance instance = instances.plain(80, 4, Aim.minMax());
        int[][] good = search(instance, 1, Budget.iterations(20_000)).orders();
        double before = new Judge(instance).verdict(good).aim();

        Allocation found = new Allocator(instance).improve(good, 2, SHORT, better -> {});

        assertThat(new Judge(instance).verdict(found.orders()).aim()).isLessThanOrEqualTo(before + 1e-9);
    }

    @Test
    void putsOrphansIntoThePlanAtHand() {
        Instance instance = instances.plain(40, 3, Aim.minMax());
        int[][] orders = search(instance, 1, SHORT).orders();
        orders[0] = new int[0];

        Allocation found = new Allocator(instance).improve(orders, 1, Budget.iterations(1), better -> {});

        assertThat(found.unserved()).isEmpty();
    }

    @Test
    void answersAProblemWithoutWaypoints() {
        Allocation found = search(instances.plain(0, 2, Aim.minMax()), 1, SHORT);

        assertThat(found.orders()).hasDimensions(2, 0);
        assertThat(found.longestSeconds()).isZero();
    }
}
