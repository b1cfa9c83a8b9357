package org.dronemap.ws.house;

import java.time.Duration;
import java.util.Optional;
import java.util.function.Supplier;
import org.awaitility.Awaitility;

/** Waits for conditions with a deadline. */
public final class Waiting {
    private Waiting() {}

    public static <T> T until(String what, Supplier<Optional<T>> condition) {
        return Awaitility.await(what)
                .atMost(Duration.ofSeconds(30))
                .pollInterval(Duration.ofMillis(20))
                .until(condition::get, Optional::isPresent)
                .orElseThrow();
    }
}
