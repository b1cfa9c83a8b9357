package org.dronemap.core.cloud;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.function.BooleanSupplier;
import org.dronemap.core.time.SteppedTime;

/** Lets stepped time go by until something holds, or while it does. */
final class SteppedUntil {
    private static final Duration LONGEST = Duration.ofSeconds(30);

    private SteppedUntil() {}

    /** Until it holds, with all that follows from it at the same moment. */
    static void until(SteppedTime time, BooleanSupplier holds) {
        assertThat(time.advanceUntil(holds, LONGEST))
                .as("it holds within " + LONGEST)
                .isTrue();
        time.settle();
    }

    /** So long; it has to hold all the while. */
    static void throughout(SteppedTime time, Duration duration, BooleanSupplier holds) {
        assertThat(time.advanceUntil(() -> !holds.getAsBoolean(), duration))
                .as("it ceases to hold within " + duration)
                .isFalse();
    }
}
