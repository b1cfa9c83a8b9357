package org.dronemap.proxy.endpoint;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.LongAdder;

/** Counters of the traffic of one endpoint since its start. Any thread. */
public final class EndpointCounters {
    private final LongAdder framesIn = new LongAdder();
    private final LongAdder framesOut = new LongAdder();
    private final LongAdder lost = new LongAdder();
    private final LongAdder brokenBytes = new LongAdder();
    private final LongAdder droppedIn = new LongAdder();
    private final LongAdder droppedOut = new LongAdder();
    private final LongAdder throttled = new LongAdder();
    private final LongAdder refusedPeers = new LongAdder();
    private final AtomicInteger peers = new AtomicInteger();

    /**
     * The counts at one moment.
     *
     * @param lost messages missing from vehicles' sequence numbers
     * @param droppedIn frames that found no room on their way to the drone
     * @param droppedOut frames that the link did not take
     * @param throttled deliveries of peers that made too much work, dropped unread
     * @param refusedPeers datagrams or connections of addresses beyond the bound
     */
    public record Counts(
            int peers,
            long framesIn,
            long framesOut,
            long lost,
            long brokenBytes,
            long droppedIn,
            long droppedOut,
            long throttled,
            long refusedPeers) {}

    void received(long frames, long broken) {
        framesIn.add(frames);
        brokenBytes.add(broken);
    }

    void lost(long messages) {
        lost.add(messages);
    }

    void droppedIn() {
        droppedIn.increment();
    }

    void sent() {
        framesOut.increment();
    }

    void droppedOut() {
        droppedOut.increment();
    }

    void throttled() {
        throttled.increment();
    }

    void refusedPeer() {
        refusedPeers.increment();
    }

    void peers(int count) {
        peers.set(count);
    }

    public Counts counts() {
        return new Counts(
                peers.get(),
                framesIn.sum(),
                framesOut.sum(),
                lost.sum(),
                brokenBytes.sum(),
                droppedIn.sum(),
                droppedOut.sum(),
                throttled.sum(),
                refusedPeers.sum());
    }
}
