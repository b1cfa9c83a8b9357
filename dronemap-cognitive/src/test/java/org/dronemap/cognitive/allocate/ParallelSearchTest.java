package org.dronemap.cognitive.allocate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.dronemap.cognitive.cost.AllocationObjective;
import org.dronemap.cognitive.cost.AllocationProblem;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Searches side by side find the best of what each finds alone. */
class ParallelSearchTest {
    private static final SearchBudget SHORT = SearchBudget.iterations(3_000);

    private final AllocationProblem instance =
            new RandomAllocationProblems(2).plain(80, 4, AllocationObjective.minMax());
    private final ExecutorService threads = Executors.newFixedThreadPool(2);

    @AfterEach
    void endThreads() {
        threads.shutdownNow();
    }

    @Test
    void findsTheBestOfWhatEachSearchFindsAlone() {
        double least = Double.POSITIVE_INFINITY;
        for (int number = 0; number < 3; number++) {
            double alone = new ParallelSearch(new Allocator(instance), 1, threads)
                    .search(5 + 1_000_003L * number, SHORT, better -> {})
                    .longestSeconds();
            least = Math.min(least, alone);
        }

        Allocation together = new ParallelSearch(new Allocator(instance), 3, threads).search(5, SHORT, better -> {});

        assertThat(together.longestSeconds()).isEqualTo(least);
    }

    @Test
    void tellsOnlyOfPlansThatAreBetterThanAllBefore() {
        List<Double> heard = Collections.synchronizedList(new ArrayList<>());
        Allocation found = new ParallelSearch(new Allocator(instance), 3, threads)
                .search(1, SearchBudget.iterations(20_000), better -> heard.add(better.longestSeconds()));

        assertThat(heard).hasSizeGreaterThan(2).isSortedAccordingTo((one, other) -> Double.compare(other, one));
        assertThat(found.longestSeconds()).isLessThanOrEqualTo(heard.get(heard.size() - 1));
    }

    @Test
    void endsAllSearchesWhenOneFails() {
        ParallelSearch crew = new ParallelSearch(new Allocator(instance), 2, threads);
        SearchBudget endless = iterations -> 0;

        assertThatThrownBy(() -> crew.search(1, endless, better -> {
                    throw new IllegalStateException("nobody wants to hear");
                }))
                .hasStackTraceContaining("nobody wants to hear");
    }
}
