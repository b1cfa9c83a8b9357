package org.dronemap.proxy.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

/** What is in use after a collection must not grow with the input. */
final class HeapGrowthCheck {
    private static final long MOST_GROWTH_BYTES = 24L * 1024 * 1024;
    private static final int COLLECTIONS = 4;

    private final long before = used();

    void check(String name) {
        long growth = used() - before;
        System.out.printf(
                "fuzzed the %s: the slowest input made %.2f ms of work, the heap grew by %d kB%n",
                name, SlowInputCheck.takeSlowestNanos() / 1e6, growth / 1024);
        assertThat(growth).as("growth of the heap (%s)", name).isLessThan(MOST_GROWTH_BYTES);
    }

    private static long used() {
        long least = Long.MAX_VALUE;
        for (int i = 0; i < COLLECTIONS; i++) {
            System.gc();
            Runtime runtime = Runtime.getRuntime();
            least = Math.min(least, runtime.totalMemory() - runtime.freeMemory());
        }
        return least;
    }
}
