package org.dronemap.ws.testserver;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.concurrent.atomic.AtomicLong;

/** The system's time, put forward by tests. */
public final class AdjustableClock implements InstantSource {
    private final AtomicLong aheadMillis = new AtomicLong();

    @Override
    public Instant instant() {
        return Clock.systemUTC().instant().plusMillis(aheadMillis.get());
    }

    public void forward(Duration step) {
        aheadMillis.addAndGet(step.toMillis());
    }
}
