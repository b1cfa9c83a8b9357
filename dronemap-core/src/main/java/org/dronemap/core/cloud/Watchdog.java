package org.dronemap.core.cloud;

import java.time.Duration;
import org.dronemap.core.drone.LinkState;

/** Judges silence. Any valid message is life; a link that is never silent for long becomes suspect sooner. */
public record Watchdog(Duration suspectAfter, Duration probeAfter, Duration lostAfter) {
    private static final long SOONEST_SUSPICION_NANOS = Duration.ofMillis(1500).toNanos();
    private static final int NORMAL_SILENCES = 2;

    /** Suspect after at most 3 s, probed at 3 s, lost at 5 s. */
    public static final Watchdog DEFAULT =
            new Watchdog(Duration.ofSeconds(3), Duration.ofSeconds(3), Duration.ofSeconds(5));

    public Watchdog {
        if (suspectAfter.compareTo(lostAfter) > 0 || probeAfter.compareTo(lostAfter) > 0) {
            throw new IllegalArgumentException("a drone must be suspect and probed before it is lost: suspect after "
                    + suspectAfter + ", probed after " + probeAfter + ", lost after " + lostAfter);
        }
    }

    /** {@code normalSilenceNanos}: how long this link falls silent now and then without meaning anything by it. */
    public LinkState judge(long silenceNanos, long normalSilenceNanos) {
        if (silenceNanos >= lostAfter.toNanos()) {
            return LinkState.LOST;
        }
        long suspicion = Math.max(SOONEST_SUSPICION_NANOS, NORMAL_SILENCES * normalSilenceNanos);
        return silenceNanos >= Math.min(suspicion, suspectAfter.toNanos()) ? LinkState.SUSPECT : LinkState.LIVE;
    }
}
