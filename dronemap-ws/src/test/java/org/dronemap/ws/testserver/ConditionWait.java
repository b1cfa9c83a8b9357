package org.dronemap.ws.testserver;

import java.time.Duration;
import java.util.Optional;
import java.util.function.Supplier;
import org.awaitility.Awaitility;
import org.awaitility.pollinterval.IterativePollInterval;

/** Waits for conditions with a deadline: looks at once, then soon, then less often. */
public final class ConditionWait {
    private static final Duration FIRST_PAUSE = Duration.ofMillis(2);
    private static final Duration LONGEST_PAUSE = Duration.ofMillis(20);

    private ConditionWait() {}

    public static <T> T until(String what, Supplier<Optional<T>> condition) {
        return Awaitility.await(what)
                .atMost(Duration.ofSeconds(30))
                .pollDelay(Duration.ZERO)
                .pollInterval(IterativePollInterval.iterative(ConditionWait::longer, FIRST_PAUSE))
                .until(condition::get, Optional::isPresent)
                .orElseThrow();
    }

    private static Duration longer(Duration pause) {
        Duration twice = pause.multipliedBy(2);
        return twice.compareTo(LONGEST_PAUSE) > 0 ? LONGEST_PAUSE : twice;
    }
}
