package org.dronemap.core.drone;

import org.jspecify.annotations.Nullable;

/**
 * Measured quality of a vehicle's link: message loss, round-trip time and jitter, each over some 5 s and some 60 s, null
 * while unknown.
 *
 * @param lossShort share of the vehicle's messages that did not arrive, 0 to 1, over some 5 s
 * @param lossLong the same over some 60 s
 * @param roundTripMillis smoothed time from a question to its answer
 * @param roundTripLongMillis the same over some 60 s
 * @param jitterMillis by how much the vehicle's messages come sooner or later than the ones before them, over some 5 s
 * @param jitterLongMillis the same over some 60 s
 */
public record LinkQuality(
        @Nullable Double lossShort,
        @Nullable Double lossLong,
        @Nullable Double roundTripMillis,
        @Nullable Double roundTripLongMillis,
        @Nullable Double jitterMillis,
        @Nullable Double jitterLongMillis) {
    public static final LinkQuality UNKNOWN = new LinkQuality(null, null, null);

    /** Nothing is known of its jitter, nor of its round trips over a longer time. */
    public LinkQuality(@Nullable Double lossShort, @Nullable Double lossLong, @Nullable Double roundTripMillis) {
        this(lossShort, lossLong, roundTripMillis, null, null, null);
    }
}
