package org.dronemap.core.time;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class WaitStrategyTest {
    private final WaitStrategy rhythm = new WaitStrategy();
    private int waits;

    @Test
    void waitsToBeWokenWhenNothingWasFound() {
        rhythm.pause(false, () -> waits++);
        rhythm.pause(false, () -> waits++);

        assertThat(waits).isEqualTo(2);
    }

    @Test
    void looksByItselfWhileWorkComesFaster() {
        // The scheduler may make a short wait long, but not every one.
        await().until(() -> {
            waits = 0;
            rhythm.pause(false, () -> waits++);
            rhythm.pause(true, () -> waits++);
            rhythm.pause(true, () -> waits++);
            return waits == 1;
        });
    }

    @Test
    void waitsToBeWokenWhenWorkIsRare() {
        rhythm.pause(false, () -> {
            waits++;
            long began = System.nanoTime();
            await().until(() -> System.nanoTime() - began > TimeUnit.MILLISECONDS.toNanos(5));
        });

        rhythm.pause(true, () -> waits++);

        assertThat(waits).isEqualTo(2);
    }
}
