package org.dronemap.proxy.endpoint;

import org.jspecify.annotations.Nullable;

/** One peer and what went between it and its endpoint; {@code identity} is null on links that prove nothing. */
public record PeerStatus(
        PeerAddress address,
        @Nullable String identity,
        long framesIn,
        long framesOut,
        long brokenBytes,
        long dropped,
        long silentMillis) {
    static PeerStatus of(Seat seat, long now) {
        PeerCounters counters = seat.counters();
        return new PeerStatus(
                seat.address(),
                seat.authenticatedIdentity().orElse(null),
                counters.framesIn(),
                counters.framesOut(),
                counters.brokenBytes(),
                counters.dropped(),
                (now - seat.lastHeardNanos()) / 1_000_000);
    }
}
