package org.dronemap.core.cloud.lane;

import java.time.Duration;
import org.dronemap.core.drone.LinkState;

/**
 * Time limits after which a drone's link counts as suspect or lost; judges a silence by them. Any valid message is
 * life; a link that is never silent for long becomes suspect sooner.
 *
 * @param soonestSuspicion no shorter silence is suspect, however steady the link was
 * @param suspectAfter so long a silence is, whatever is normal for the link
 */
public record Watchdog(Duration soonestSuspicion, Duration suspectAfter, Duration probeAfter, Duration lostAfter) {
    private static final Duration USUAL_SOONEST = Duration.ofMillis(1500);
    private static final int NORMAL_SILENCES = 2;

    /** Suspect after at most 3 s, probed at 3 s, lost at 5 s. */
    public static final Watchdog DEFAULT =
            new Watchdog(Duration.ofSeconds(3), Duration.ofSeconds(3), Duration.ofSeconds(5));

    public Watchdog(Duration suspectAfter, Duration probeAfter, Duration lostAfter) {
        this(USUAL_SOONEST, suspectAfter, probeAfter, lostAfter);
    }

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
        long suspicion = Math.max(soonestSuspicion.toNanos(), NORMAL_SILENCES * normalSilenceNanos);
        return silenceNanos >= Math.min(suspicion, suspectAfter.toNanos()) ? LinkState.SUSPECT : LinkState.LIVE;
    }
}
