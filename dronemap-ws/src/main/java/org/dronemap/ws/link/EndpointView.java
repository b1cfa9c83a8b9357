package org.dronemap.ws.link;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * An endpoint that vehicles connect to, with its state and counters, as clients see it.
 *
 * @param origin configured (by the setting) or added (by somebody, at run time)
 * @param state open, connecting or failed; a failed one is tried again
 * @param peers the first hundred
 */
@Schema(name = "EndpointView")
public record EndpointView(
        String id,
        String url,
        String transport,
        @Schema(allowableValues = {"configured", "added"}) String origin,
        @Nullable String addedBy,
        @Nullable Instant addedAt,

        @Schema(allowableValues = {"open", "connecting", "failed"})
        String state,

        @Nullable String reason,
        Counts counts,
        List<PeerView> peers) {

    /** Counts since the endpoint opened; kernelDrops is null where the system does not tell. */
    @Schema(name = "EndpointCounts")
    public record Counts(
            int peers,
            long framesIn,
            long framesOut,
            long lost,
            long brokenBytes,
            long droppedIn,
            long droppedOut,
            long throttled,
            long refusedPeers,
            long queue,
            @Nullable Long kernelDrops) {}

    /** One address or device that is heard there; identity is what an authenticated link proved. */
    @Schema(name = "EndpointPeerView")
    public record PeerView(
            String address,
            @Nullable String identity,
            long framesIn,
            long framesOut,
            long lost,
            long brokenBytes,
            long dropped,
            int queue,
            double silentSeconds) {}
}
