package org.dronemap.proxy.record;

import java.time.Clock;
import java.time.Instant;
import java.time.ZoneId;
import java.time.ZoneOffset;
import org.jspecify.annotations.Nullable;

/** A clock that stands until it is told. */
final class ManualClock extends Clock {
    private volatile Instant now;
    private volatile @Nullable Jump jump;

    ManualClock(Instant start) {
        now = start;
    }

    void pass(int seconds) {
        now = now.plusSeconds(seconds);
    }

    /** Time passes while that thread works on what it has just looked at the clock for. */
    void passAfterTheNextLookOf(String thread, int seconds) {
        jump = new Jump(thread, seconds);
    }

    @Override
    public ZoneId getZone() {
        return ZoneOffset.UTC;
    }

    @Override
    public Clock withZone(ZoneId zone) {
        return this;
    }

    @Override
    public Instant instant() {
        Instant seen = now;
        Jump due = jump;
        if (due != null && Thread.currentThread().getName().equals(due.thread())) {
            jump = null;
            pass(due.seconds());
        }
        return seen;
    }

    private record Jump(String thread, int seconds) {}
}
