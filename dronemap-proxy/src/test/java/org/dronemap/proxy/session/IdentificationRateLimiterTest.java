package org.dronemap.proxy.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class IdentificationRateLimiterTest {
    private static final long SECOND = 1_000_000_000L;

    private final IdentificationRateLimiter allowance = new IdentificationRateLimiter();

    private long taken(int tries, long nowNanos) {
        return IntStream.range(0, tries)
                .filter(i -> allowance.tryAcquire(nowNanos))
                .count();
    }

    @Test
    void aFloodOfStrangersIsAskedNoMoreThanTheAllowance() {
        assertThat(taken(10_000, 5 * SECOND)).isEqualTo(400);
        assertThat(taken(10_000, 6 * SECOND)).isEqualTo(200);
    }

    @Test
    void whatIsSavedUpIsBoundedToo() {
        taken(10_000, 5 * SECOND);
        assertThat(taken(10_000, 5_000 * SECOND)).isEqualTo(400);
    }
}
