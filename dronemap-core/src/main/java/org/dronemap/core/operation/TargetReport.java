package org.dronemap.core.operation;

import java.time.Duration;
import java.time.Instant;
import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/**
 * A position report of a follow's target, such as from a phone, sent about once a second; not journaled. Told once or
 * more a second, and not written down.
 *
 * @param number rises from one to the next, so that what is said twice counts once
 * @param observedAt by the clock of who says it
 * @param sentAt when it was said, by the same clock
 * @param receivedAt when it came, by the cloud's
 * @param roundTrip from saying something to the answer, as measured by who says it; null: not measured
 * @param accuracyMeters it is within so much of the place in two cases of three
 * @param motion how it moves; null: not said
 */
public record TargetReport(
        long number,
        Instant observedAt,
        Instant sentAt,
        Instant receivedAt,
        @Nullable Duration roundTrip,
        Geodetic point,
        double accuracyMeters,
        @Nullable Motion motion) {
    /** What was seen longer ago than this says nothing of now. */
    private static final Duration STALE = Duration.ofSeconds(5);

    /** It was said soon after it was seen. */
    public boolean isFresh() {
        return Duration.between(observedAt, sentAt).compareTo(STALE) <= 0;
    }

    /** Over the ground, m/s, and degrees clockwise from north. */
    public record Motion(double speed, double courseDegrees) {}
}
