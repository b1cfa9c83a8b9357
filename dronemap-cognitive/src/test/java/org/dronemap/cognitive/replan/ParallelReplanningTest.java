package org.dronemap.cognitive.replan;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.ForkJoinPool;
import org.dronemap.cognitive.allocate.SearchBudget;
import org.dronemap.cognitive.engine.FleetPlanner;
import org.junit.jupiter.api.Test;

class ParallelReplanningTest {
    private static final SearchBudget SHORT = SearchBudget.iterations(5_000);

    @Test
    void twoSearchesAtTheSameTimeAnswerWhatTheBetterOneWouldAlone() {
        int others = 0;
        for (int seed = 1; seed <= 10; seed++) {
            Replanner replanning =
                    FleetPlanner.replanning(DroneLoss.of(seed, 40, 4).situation());
            ReplanResult one = replanning.improve(seed, SHORT);
            ReplanResult other = replanning.improve(seed + 1_000_003, SHORT);
            ReplanResult both = replanning.improve(seed, SHORT, 2, ForkJoinPool.commonPool());

            assertThat(both).isIn(one, other);
            assertThat(both.after().cost())
                    .isLessThanOrEqualTo(
                            1.0031 * Math.min(one.after().cost(), other.after().cost()));
            others += both.equals(other) && !both.equals(one) ? 1 : 0;
        }
        assertThat(others).isBetween(1, 9);
    }
}
