package org.dronemap.bench.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

class CpuBudgetTest {
    @Test
    void countsFromItsBeginning() {
        AtomicLong cpu = new AtomicLong(5_000_000_000L);
        CpuBudget allowance = CpuBudget.fromNow(2, cpu::get);

        assertThat(allowance.usedSeconds()).isZero();
        cpu.addAndGet(1_500_000_000L);
        assertThat(allowance.share()).isEqualTo(0.75);
        assertThat(allowance.isSpent()).isFalse();
        cpu.addAndGet(500_000_000L);
        assertThat(allowance.isSpent()).isTrue();
    }

    @Test
    void whatTheProcessUsedBeforeCountsFromItsStart() {
        assertThat(CpuBudget.ofProcess(1e-6).isSpent()).isTrue();
    }
}
