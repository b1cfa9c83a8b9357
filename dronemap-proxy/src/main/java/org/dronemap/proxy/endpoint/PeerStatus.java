package org.dronemap.proxy.endpoint;

import org.jspecify.annotations.Nullable;

/**
 * A snapshot of one peer of an endpoint: address, identity, traffic counters and how long it has been silent.
 *
 * @param identity null on links that prove nothing
 * @param queue frames that wait to be sent
 */
public record PeerStatus(
        PeerAddress address,
        @Nullable String identity,
        long framesIn,
        long framesOut,
        long lost,
        long brokenBytes,
        long dropped,
        int queue,
        long silentMillis) {
    static PeerStatus of(EndpointPeer seat, long now) {
        PeerCounters counters = seat.counters();
        return new PeerStatus(
                seat.address(),
                seat.authenticatedIdentity().orElse(null),
                counters.framesIn(),
                counters.framesOut(),
                counters.lost(),
                counters.brokenBytes(),
                counters.dropped(),
                seat.wire().waiting(),
                (now - seat.lastReceivedNanos()) / 1_000_000);
    }
}
