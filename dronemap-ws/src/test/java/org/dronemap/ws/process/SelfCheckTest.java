package org.dronemap.ws.process;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import org.dronemap.core.cloud.Lane;
import org.dronemap.core.process.PastEnd;
import org.dronemap.core.time.SystemTime;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SelfCheckTest {
    private static final int LOOKS_UNTIL_IT_IS_DEAD = 6;

    @TempDir
    private Path data;

    private final SystemTime time = new SystemTime();
    private final CountDownLatch mayGoOn = new CountDownLatch(1);
    private final AtomicInteger halted = new AtomicInteger();
    private final Lane lane = new Lane(time, "lane-7", 10);

    private SelfCheck check() {
        RunFile run = RunFile.begin(data.resolve("run-state"), Instant.EPOCH, "");
        return new SelfCheck(run, new ProcessEnd(run, time.clock(), halted::set), List.of(lane), time);
    }

    @AfterEach
    void close() {
        mayGoOn.countDown();
        lane.close();
    }

    @Test
    void aLaneThatStandsStillEndsTheProcess() {
        CountDownLatch stands = new CountDownLatch(1);
        lane.execute(() -> {
            stands.countDown();
            waitFor(mayGoOn);
        });
        waitFor(stands);
        try (SelfCheck check = check()) {
            for (int look = 1; look < LOOKS_UNTIL_IT_IS_DEAD; look++) {
                check.look();
            }
            assertThat(halted).hasValue(0);

            check.look();
        }

        assertThat(halted).hasValue(ProcessEnd.EXIT_CODE);
        PastEnd end = RunFile.begin(data.resolve("run-state"), Instant.EPOCH, "")
                .before()
                .orElseThrow();
        assertThat(end.part()).isEqualTo("lane-7");
        assertThat(end.why()).startsWith("It has stood still for");
    }

    @Test
    void aLaneThatMovesBetweenTwoLooksIsWell() {
        try (SelfCheck check = check()) {
            for (int look = 0; look < 3 * LOOKS_UNTIL_IT_IS_DEAD; look++) {
                long before = lane.turns();
                check.look();
                CountDownLatch moved = new CountDownLatch(1);
                lane.execute(moved::countDown);
                waitFor(moved);
                // A turn counts when it took a while; the next one does at the latest.
                while (lane.turns() == before) {
                    Thread.onSpinWait();
                }
            }
        }

        assertThat(halted).hasValue(0);
    }

    private static void waitFor(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }
}
