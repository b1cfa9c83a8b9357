package org.dronemap.proxy.endpoint;

import java.util.concurrent.atomic.LongAdder;

/** Counters of the traffic between one peer and its endpoint; they add to the endpoint's own. Any thread. */
public final class PeerCounters {
    private final EndpointCounters endpoint;
    private final LongAdder framesOut = new LongAdder();
    private final LongAdder dropped = new LongAdder();
    private volatile long framesIn;
    private volatile long brokenBytes;
    private volatile long lost;

    public PeerCounters(EndpointCounters endpoint) {
        this.endpoint = endpoint;
    }

    /** Good frames and bytes that belong to none; on the endpoint's thread only. */
    @SuppressWarnings("NonAtomicVolatileUpdate") // one thread writes
    public void received(long frames, long broken) {
        framesIn = framesIn + frames;
        brokenBytes = brokenBytes + broken;
        endpoint.received(frames, broken);
    }

    /** Messages found missing, or late after all when negative; on the endpoint's thread only. */
    @SuppressWarnings("NonAtomicVolatileUpdate") // one thread writes
    public void lost(long messages) {
        if (messages != 0) {
            lost = lost + messages;
            endpoint.lost(messages);
        }
    }

    /** A frame found no room on its way to the drone. */
    public void droppedIn() {
        dropped.increment();
        endpoint.droppedIn();
    }

    void throttled() {
        dropped.increment();
        endpoint.throttled();
    }

    void sent(boolean taken) {
        if (taken) {
            framesOut.increment();
            endpoint.sent();
        } else {
            dropped.increment();
            endpoint.droppedOut();
        }
    }

    long framesIn() {
        return framesIn;
    }

    long brokenBytes() {
        return brokenBytes;
    }

    long lost() {
        return lost;
    }

    long framesOut() {
        return framesOut.sum();
    }

    long dropped() {
        return dropped.sum();
    }
}
