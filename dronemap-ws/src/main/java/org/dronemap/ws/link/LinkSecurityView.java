package org.dronemap.ws.link;

import io.swagger.v3.oas.annotations.media.Schema;
import org.dronemap.core.access.LinkSigningPolicy;
import org.dronemap.ws.reading.EnumValues;
import org.jspecify.annotations.Nullable;

/** MAVLink signing of a drone's links as clients see it, with key fingerprints and counters but no secret. */
@Schema(name = "LinkSecurityView", description = "How a drone's link is secured; a key shows its fingerprint only.")
public record LinkSecurityView(
        @EnumValues(LinkSigningPolicy.class) String policy,
        @Nullable Key key,

        @Schema(description = "Fingerprint of the key that is being changed over to") @Nullable
        String nextKey,

        @Schema(description = "While that is under way") @EnumValues(LinkSecurityGateway.Change.class) @Nullable
        String changing,

        @Schema(description = "Whether a key may be sent over the present link; null: there is none") @Nullable
        Boolean safeLink,

        Messages messages) {

    /** {@code inUse}: the vehicle was heard signing with it. */
    @Schema(name = "LinkSecurityKey")
    public record Key(String fingerprint, boolean inUse) {}

    /** Counts since the server's start. */
    @Schema(name = "LinkSecurityMessages")
    public record Messages(
            long valid, long unsigned, long badSignature, long replayed, long tooOld, long tooManyStreams) {}
}
