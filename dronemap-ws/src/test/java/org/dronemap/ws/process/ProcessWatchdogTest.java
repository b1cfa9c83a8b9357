package org.dronemap.ws.process;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import org.dronemap.core.cloud.lane.Lane;
import org.dronemap.core.process.ProcessCrash;
import org.dronemap.core.time.RealTime;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ProcessWatchdogTest {
    private static final int LOOKS_UNTIL_IT_IS_DEAD = 6;

    @TempDir
    private Path data;

    private final RealTime time = new RealTime();
    private final CountDownLatch mayGoOn = new CountDownLatch(1);
    private final AtomicInteger halted = new AtomicInteger();
    private final Lane lane = new Lane(time, "lane-7", 10);

    private ProcessWatchdog check() {
        ProcessStateFile run = ProcessStateFile.begin(data.resolve("run-state"), Instant.EPOCH, "");
        return new ProcessWatchdog(run, new ProcessTerminator(run, time.clock(), halted::set), List.of(lane), time);
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
        try (ProcessWatchdog check = check()) {
            for (int look = 1; look < LOOKS_UNTIL_IT_IS_DEAD; look++) {
                check.check();
            }
            assertThat(halted).hasValue(0);

            check.check();
        }

        assertThat(halted).hasValue(ProcessTerminator.EXIT_CODE);
        ProcessCrash end = ProcessStateFile.begin(data.resolve("run-state"), Instant.EPOCH, "")
                .before()
                .orElseThrow();
        assertThat(end.part()).isEqualTo("lane-7");
        assertThat(end.why()).startsWith("It has stood still for");
    }

    @Test
    void aLaneThatMovesBetweenTwoLooksIsWell() {
        try (ProcessWatchdog check = check()) {
            for (int look = 0; look < 3 * LOOKS_UNTIL_IT_IS_DEAD; look++) {
                long before = lane.turns();
                check.check();
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
