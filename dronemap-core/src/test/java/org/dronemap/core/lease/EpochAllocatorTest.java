package org.dronemap.core.lease;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.List;
import java.util.Queue;
import org.dronemap.core.drone.DroneId;
import org.junit.jupiter.api.Test;

class EpochAllocatorTest {
    private static final int MANY = 350_000;

    private final Reserve reserve = new Reserve();

    @Test
    void risesForEverAndIsSetAsideBeforeItIsHandedOut() {
        EpochAllocator epochs = new EpochAllocator(reserve, Runnable::run);
        long before = 0;
        for (int i = 0; i < MANY; i++) {
            long next = epochs.next();
            assertThat(next).isGreaterThan(before).isLessThanOrEqualTo(reserve.reserved);
            before = next;
        }
    }

    @Test
    void risesOnWhenTheBackgroundNeverComesOrComesLate() {
        Queue<Runnable> late = new ArrayDeque<>();
        EpochAllocator epochs = new EpochAllocator(reserve, late::add);
        long before = 0;
        for (int i = 0; i < MANY; i++) {
            if (i % 110_000 == 0 && !late.isEmpty()) {
                late.remove().run();
            }
            long next = epochs.next();
            assertThat(next).isGreaterThan(before).isLessThanOrEqualTo(reserve.reserved);
            before = next;
        }
    }

    @Test
    void neverRepeatsAfterARestart() {
        long last = new EpochAllocator(reserve, Runnable::run).next();

        assertThat(new EpochAllocator(reserve, Runnable::run).next()).isGreaterThan(last);
    }

    /** Only counts. */
    private static final class Reserve implements LeaseStore {
        private long reserved;

        @Override
        public List<SavedLease> leases() {
            return List.of();
        }

        @Override
        public void save(SavedLease lease) {
            throw new AssertionError();
        }

        @Override
        public void delete(DroneId drone) {
            throw new AssertionError();
        }

        @Override
        public long reserve(int count) {
            reserved += count;
            return reserved;
        }
    }
}
