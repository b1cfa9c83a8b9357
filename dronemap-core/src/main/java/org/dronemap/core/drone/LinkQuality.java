package org.dronemap.core.drone;

import org.jspecify.annotations.Nullable;

/**
 * Measured quality of a vehicle's link: message loss and round-trip time, each null while unknown.
 *
 * @param lossShort share of the vehicle's messages that did not arrive, 0 to 1, over some 5 s
 * @param lossLong the same over some 60 s
 * @param roundTripMillis smoothed time from a question to its answer
 */
public record LinkQuality(
        @Nullable Double lossShort,
        @Nullable Double lossLong,
        @Nullable Double roundTripMillis) {
    public static final LinkQuality UNKNOWN = new LinkQuality(null, null, null);
}
