package org.dronemap.cognitive.operation.follow;

import java.time.Duration;
import java.time.Instant;
import org.dronemap.cognitive.operation.CopterEndurance;
import org.jspecify.annotations.Nullable;

/** Decides whether a replaced drone of a follow flies home by setpoints, or is commanded to return by itself. */
final class GuidedReturn {
    private static final double NEAR_METERS = 15;
    /** By then it is far from where it set off. */
    private static final Duration LONGEST = Duration.ofSeconds(60);

    private GuidedReturn() {}

    /** Whether it may be led still, whatever is seen of it. */
    static boolean mayBeSteered(FollowState one, Instant at) {
        return one.stage() == FollowStage.RETURNING && at.isBefore(one.since().plus(LONGEST));
    }

    /**
     * Whether it is to be led, and not told to come home by itself yet.
     *
     * @param one that was replaced
     * @param guided it goes by what it is led by
     * @param homeMeters from its home; null: not known
     */
    static boolean isSteered(
            FollowState one, boolean guided, @Nullable Double homeMeters, @Nullable Integer percent, Instant at) {
        return one.stage() == FollowStage.RETURNING
                && one.issuedCommand() == null
                && one.attempts().failed() == 0
                && guided
                && homeMeters != null
                && homeMeters > NEAR_METERS
                && (percent == null
                        || percent >= CopterEndurance.RESERVE_PERCENT + CopterEndurance.percentBack(homeMeters))
                && at.isBefore(one.since().plus(LONGEST));
    }
}
