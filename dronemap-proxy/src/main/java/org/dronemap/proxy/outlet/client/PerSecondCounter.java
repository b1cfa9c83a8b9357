package org.dronemap.proxy.outlet.client;

/** Counts events of an outlet client, in all and within the last full second. Not thread-safe. */
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
