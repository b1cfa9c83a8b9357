package org.dronemap.cognitive.follow;

import java.time.Instant;
import org.dronemap.core.geo.Geodetic;

/**
 * Where a phone says that it was.
 *
 * @param at by the cloud's clock, see {@link PhoneClock}
 * @param accuracyMeters the phone is within so much of the place in two cases of three, by its own word
 */
public record PhoneFix(Instant at, Geodetic point, double accuracyMeters) {
    public PhoneFix {
        if (!(accuracyMeters >= 0)) {
            throw new IllegalArgumentException("an accuracy is 0 or more metres: " + accuracyMeters);
        }
    }
}
