package org.dronemap.cognitive.allocate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.dronemap.cognitive.cost.Aim;
import org.dronemap.cognitive.cost.Instance;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Searches side by side find the best of what each finds alone. */
class CrewTest {
    private static final Budget SHORT = Budget.iterations(3_000);

    private final Instance instance = new RandomInstances(2).plain(80, 4, Aim.minMax());
    private final ExecutorService threads = Executors.newFixedThreadPool(2);

    @AfterEach
    void endThreads() {
        threads.shutdownNow();
    }

    @Test
    void findsTheBestOfWhatEachSearchFindsAlone() {
        double least = Double.POSITIVE_INFINITY;
        for (int number = 0; number < 3; number++) {
            double alone = new Crew(new Allocator(instance), 1, threads)
                    .search(5 + 1_000_003L * number, SHORT, better -> {})
                    .longestSeconds();
            least = Math.min(least, alone);
        }

        Allocation together = new Crew(new Allocator(instance), 3, threads).search(5, SHORT, better -> {});

        assertThat(together.longestSeconds()).isEqualTo(least);
    }

    @Test
    void tellsOnlyOfPlansThatAreBetterThanAllBefore() {
        List<Double> heard = Collections.synchronizedList(new ArrayList<>());
        Allocation found = new Crew(new Allocator(instance), 3, threads)
                .search(1, Budget.iterations(20_000), better -> heard.add(better.longestSeconds()));

        assertThat(heard).hasSizeGreaterThan(2).isSortedAccordingTo((one, other) -> Double.compare(other, one));
        assertThat(found.longestSeconds()).isLessThanOrEqualTo(heard.get(heard.size() - 1));
    }

    @Test
    void endsAllSearchesWhenOneFails() {
        Crew crew = new Crew(new Allocator(instance), 2, threads);
        Budget endless = iterations -> 0;

        assertThatThrownBy(() -> crew.search(1, endless, better -> {
                    throw new IllegalStateException("nobody wants to hear");
                }))
                .hasStackTraceContaining("nobody wants to hear");
    }
}
