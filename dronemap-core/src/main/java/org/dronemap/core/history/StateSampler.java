package org.dronemap.core.history;

import java.time.Duration;
import java.time.Instant;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.jspecify.annotations.Nullable;

/** Chooses which states of one drone are kept in the history. Owned by the drone's {@link DroneHistoryRecorder}. */
final class StateSampler {
    private final HistoryPolicy policy;
    private @Nullable DroneState kept;

    StateSampler(HistoryPolicy policy) {
        this.policy = policy;
    }

    /** True when this one is kept, too. */
    boolean shouldStore(DroneState now) {
        DroneState last = kept;
        boolean wanted = last == null ? isLinkLive(now) : turned(last, now) || (isLinkLive(now) && isDue(last, now));
        if (wanted) {
            kept = now;
        }
        return wanted;
    }

    /** Armed, disarmed, lost and found again are kept at their own moment. */
    private static boolean turned(DroneState last, DroneState now) {
        boolean armed = now.armed() != null && !now.armed().equals(last.armed());
        boolean heard = isLinkLive(now) != isLinkLive(last);
        return armed || heard;
    }

    /** Waits a little for news of where it is, so that the place belongs to the moment. */
    private boolean isDue(DroneState last, DroneState now) {
        Duration period = Boolean.TRUE.equals(now.armed()) ? policy.flying() : policy.resting();
        Duration since = Duration.between(at(last), at(now));
        if (since.isNegative()) {
            return true;
        }
        boolean moved = !isSame(now.position(), last.position());
        // A vehicle that sends as often as is kept comes a little early half of the time.
        long due = moved ? period.toNanos() * 7 / 8 : period.toNanos() * 2;
        return since.toNanos() >= due;
    }

    /** A place that was heard again is news, though it is the same. */
    private static boolean isSame(@Nullable Object one, @Nullable Object other) {
        return one == other;
    }

    private static Instant at(DroneState state) {
        return state.lastUpdate();
    }

    private static boolean isLinkLive(DroneState state) {
        LinkState link = state.link().state();
        return link == LinkState.LIVE || link == LinkState.SUSPECT;
    }
}
