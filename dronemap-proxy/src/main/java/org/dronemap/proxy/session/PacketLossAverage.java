package org.dronemap.proxy.session;

import org.jspecify.annotations.Nullable;

/**
 * The share of lost messages on a vehicle link, averaged with exponentially falling weight of old ones. Owned by the
 * drone's lane.
 */
final class PacketLossAverage {
    private static final double FEWEST_MESSAGES = 5;

    private final double memorySeconds;
    private double lost;
    private double sent;

    PacketLossAverage(double memorySeconds) {
        this.memorySeconds = memorySeconds;
    }

    /** What came and what was missing in the last {@code seconds}; less than 0 lost: some of the missing came late. */
    void add(long newlyReceived, long newlyLost, double seconds) {
        double kept = Math.exp(-seconds / memorySeconds);
        lost = Math.max(0, lost * kept + newlyLost);
        sent = Math.max(lost, sent * kept + newlyReceived + newlyLost);
    }

    /** From 0 to 1; null while too few messages came to tell. */
    @Nullable
    Double share() {
        return sent < FEWEST_MESSAGES ? null : (Double) (lost / sent);
    }
}
