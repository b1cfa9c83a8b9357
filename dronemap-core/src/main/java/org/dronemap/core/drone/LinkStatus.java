package org.dronemap.core.drone;

import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The link that reaches a drone now: address, transport, state, last heard and quality; part of DroneState.
 *
 * @param quality unknown while the drone is lost
 * @param trend unknown while the drone is lost
 * @param others further links that the same vehicle is heard on
 * @param outdated what the vehicle does not tell any more though it is heard; nothing while it is lost, when all is old
 */
public record LinkStatus(
        DroneKey key,
        String transport,
        LinkState state,
        @Nullable Instant lastHeard,
        LinkQuality quality,
        LinkTrend trend,
        List<DroneKey> others,
        List<OutdatedPart> outdated) {
    /** Everything is told, and nothing is known of where its quality goes. */
    public LinkStatus(
            DroneKey key,
            String transport,
            LinkState state,
            @Nullable Instant lastHeard,
            LinkQuality quality,
            List<DroneKey> others) {
        this(key, transport, state, lastHeard, quality, LinkTrend.UNKNOWN, others, List.of());
    }
}
