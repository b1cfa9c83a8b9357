package org.dronemap.core.cloud.lane;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.dronemap.core.time.RealTime;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class LaneTest {
    private final Lane lane = new Lane(new RealTime(), "lane-test", 8);
    private final CountDownLatch release = new CountDownLatch(1);

    @AfterEach
    void close() {
        release.countDown();
        lane.close();
    }

    @Test
    void keepsTheOrder() {
        List<Integer> seen = Collections.synchronizedList(new ArrayList<>());

        for (int i = 0; i < 8; i++) {
            int number = i;
            lane.execute(() -> seen.add(number));
        }

        await().untilAsserted(() -> assertThat(seen).containsExactly(0, 1, 2, 3, 4, 5, 6, 7));
    }

    @Test
    void dropsTelemetryAndCountsItWhileCommandsStillFindRoom() throws InterruptedException {
        block();
        int taken = 0;
        while (lane.offer(() -> {})) {
            taken++;
        }

        assertThat(taken).isEqualTo(6);
        assertThat(lane.droppedCount()).isEqualTo(1);
        lane.execute(() -> {});
        lane.execute(() -> {});
        assertThatThrownBy(() -> lane.execute(() -> {})).isInstanceOf(RejectedExecutionException.class);
    }

    @Test
    void goesOnAfterATaskThatThrows() {
        AtomicInteger after = new AtomicInteger();

        lane.execute(() -> {
            throw new IllegalStateException("on purpose");
        });
        lane.execute(after::incrementAndGet);

        await().until(() -> after.get() == 1);
        assertThat(lane.failedCount()).isEqualTo(1);
    }

    @Test
    void doesNotCountItsOwnStallAsTimeOfOthers() throws InterruptedException {
        AtomicInteger ticks = new AtomicInteger();
        lane.execute(() -> lane.addTimedTask(ticks::incrementAndGet));
        await().until(() -> ticks.get() > 0);
        long before = lane.activeNanos();
        long wallBefore = System.nanoTime();
        block();
        await().until(() -> System.nanoTime() - wallBefore > TimeUnit.MILLISECONDS.toNanos(1200));
        release.countDown();
        int seen = ticks.get();
        await().until(() -> ticks.get() > seen);

        assertThat(lane.activeNanos() - before).isLessThan(TimeUnit.MILLISECONDS.toNanos(600));
    }

    @Test
    void doesNotCountTheStallOfTheTaskThatAsks() throws InterruptedException {
        AtomicLong took = new AtomicLong();
        CountDownLatch asked = new CountDownLatch(1);
        lane.execute(() -> {
            long before = lane.activeNanos();
            long wallBefore = System.nanoTime();
            await().until(() -> System.nanoTime() - wallBefore > TimeUnit.MILLISECONDS.toNanos(1200));
            took.set(lane.activeNanos() - before);
            asked.countDown();
        });
        asked.await();

        assertThat(took.get()).isLessThan(TimeUnit.MILLISECONDS.toNanos(300));
    }

    private void block() throws InterruptedException {
        CountDownLatch started = new CountDownLatch(1);
        lane.execute(() -> {
            started.countDown();
            try {
                release.await();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        });
        started.await();
    }
}
