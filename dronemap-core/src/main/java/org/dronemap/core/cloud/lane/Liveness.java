package org.dronemap.core.cloud.lane;

import org.dronemap.core.drone.LinkState;

/**
 * Measures how long nothing came from one drone, and how long silences on its link usually are. Owned by the drone's
 * lane, {@code silence} by none.
 */
public final class Liveness {
    /** A silence that a link once showed is normal for it for about so long. */
    private static final double MEMORY_NANOS = 60e9;

    private final Watchdog watchdog;
    private volatile long lastHeardNanos;
    private long lastProbeNanos;
    private double longestGapNanos;
    private volatile boolean everHeard;

    public Liveness(Watchdog watchdog) {
        this.watchdog = watchdog;
    }

    public void received(long nowNanos) {
        if (everHeard) {
            long gap = Math.max(0, nowNanos - lastHeardNanos);
            longestGapNanos = Math.max((double) gap, longestGapNanos * (1 - Math.min(1, gap / MEMORY_NANOS)));
        }
        everHeard = true;
        lastHeardNanos = nowNanos;
        lastProbeNanos = nowNanos;
    }

    public LinkState judge(long nowNanos) {
        return everHeard ? watchdog.judge(nowNanos - lastHeardNanos, (long) longestGapNanos) : LinkState.LOST;
    }

    /** For how long it has been silent; for ever when it was never heard. Any thread. */
    public long silence(long nowNanos) {
        return everHeard ? nowNanos - lastHeardNanos : Long.MAX_VALUE;
    }

    /** True once a second while the silence wants a probe. */
    public boolean probeDue(long nowNanos) {
        boolean due = everHeard
                && nowNanos - lastHeardNanos >= watchdog.probeAfter().toNanos()
                && nowNanos - lastProbeNanos >= 1_000_000_000L;
        if (due) {
            lastProbeNanos = nowNanos;
        }
        return due;
    }
}
