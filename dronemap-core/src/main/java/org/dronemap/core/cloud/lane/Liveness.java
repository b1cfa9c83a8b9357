package org.dronemap.core.cloud.lane;

import java.time.Duration;
import org.dronemap.core.drone.LinkState;

/**
 * Measures how long nothing came from one drone, and how long silences on its link usually are. Owned by the drone's
 * lane, {@code silence} by none.
 */
public final class Liveness {
    /** A silence that a link once showed is normal for it for about so long. */
    private static final double MEMORY_NANOS = 60e9;

    /** After the first message of a vehicle that speaks seldom it is not known how seldom; satellites: once a minute. */
    private static final long FIRST_PATIENCE_NANOS = 90_000_000_000L;

    private static final long LONGEST_PATIENCE_NANOS = 600_000_000_000L;
    private static final long STEADY_NANOS = 10_000_000_000L;
    /** One that comes twice at once says nothing about the next one. */
    private static final long AGAIN_NANOS = 1_000_000_000L;

    private static final int INTERVALS = 3;

    private final Watchdog watchdog;
    private volatile long lastHeardNanos;
    private long lastProbeNanos;
    private double longestGapNanos;
    private volatile boolean everHeard;
    private boolean steady;
    private long lastSteadyNanos;
    private long lastSeldomNanos;
    private long patienceNanos;

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

    /** A message that shows at which pace the vehicle speaks. */
    public void received(LinkPace pace, long nowNanos) {
        if (pace == LinkPace.STEADY) {
            steady = true;
            lastSteadyNanos = nowNanos;
            patienceNanos = 0;
        } else if (pace == LinkPace.SELDOM) {
            seldom(nowNanos);
        }
        received(nowNanos);
    }

    /** As long as it spoke all the time a moment ago, its silence is not to be expected, whatever it says besides. */
    private void seldom(long nowNanos) {
        long gap = lastSeldomNanos == 0 ? LONGEST_PATIENCE_NANOS : nowNanos - lastSeldomNanos;
        lastSeldomNanos = nowNanos;
        if (steady && nowNanos - lastSteadyNanos < STEADY_NANOS) {
            return;
        }
        steady = false;
        long intervals = INTERVALS * gap;
        if (patienceNanos == 0) {
            boolean known = gap >= AGAIN_NANOS && intervals < LONGEST_PATIENCE_NANOS;
            patienceNanos = known ? intervals : FIRST_PATIENCE_NANOS;
        } else if (gap >= AGAIN_NANOS) {
            patienceNanos = Math.min(Math.max(intervals, patienceNanos / 2), LONGEST_PATIENCE_NANOS);
        }
    }

    /** How long the next message may take as the vehicle speaks now; zero for one that speaks all the time. */
    public Duration patience() {
        return Duration.ofNanos(patienceNanos);
    }

    public LinkState judge(long nowNanos) {
        return everHeard ? watchdog.judge(unexpectedSilence(nowNanos), (long) longestGapNanos) : LinkState.LOST;
    }

    /** Without what is to be expected of one that speaks seldom. */
    private long unexpectedSilence(long nowNanos) {
        long expected = Math.max(0, patienceNanos - watchdog.lostAfter().toNanos());
        return Math.max(0, nowNanos - lastHeardNanos - expected);
    }

    /** For how long it has been silent; for ever when it was never heard. Any thread. */
    public long silence(long nowNanos) {
        return everHeard ? nowNanos - lastHeardNanos : Long.MAX_VALUE;
    }

    /** True once a second while the silence wants a probe. */
    public boolean probeDue(long nowNanos) {
        boolean due = everHeard
                && unexpectedSilence(nowNanos) >= watchdog.probeAfter().toNanos()
                && nowNanos - lastProbeNanos >= 1_000_000_000L;
        if (due) {
            lastProbeNanos = nowNanos;
        }
        return due;
    }
}
