package org.dronemap.proxy.outlet;

/** Counts, and how many there were in the second before. Not thread-safe. */
final class PerSecondCounter {
    private long total;
    private long before;
    private long perSecond;

    void count() {
        total++;
    }

    /** A second is over. */
    void second() {
        perSecond = total - before;
        before = total;
    }

    long total() {
        return total;
    }

    long perSecond() {
        return perSecond;
    }
}
