package org.dronemap.cognitive.replan;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.ForkJoinPool;
import org.dronemap.cognitive.allocate.Budget;
import org.dronemap.cognitive.engine.Engine;
import org.junit.jupiter.api.Test;

class SearchesTogetherTest {
    private static final Budget SHORT = Budget.iterations(5_000);

    @Test
    void twoSearchesAtTheSameTimeAnswerWhatTheBetterOneWouldAlone() {
        int others = 0;
        for (int seed = 1; seed <= 10; seed++) {
            Replanning replanning = Engine.replanning(Loss.of(seed, 40, 4).situation());
            Replanned one = replanning.improve(seed, SHORT);
            Replanned other = replanning.improve(seed + 1_000_003, SHORT);
            Replanned both = replanning.improve(seed, SHORT, 2, ForkJoinPool.commonPool());

            assertThat(both).isIn(one, other);
            assertThat(both.after().cost())
                    .isLessThanOrEqualTo(
                            1.0031 * Math.min(one.after().cost(), other.after().cost()));
            others += both.equals(other) && !both.equals(one) ? 1 : 0;
        }
        assertThat(others).isBetween(1, 9);
    }
}
