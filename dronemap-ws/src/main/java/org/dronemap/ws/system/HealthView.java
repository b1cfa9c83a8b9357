package org.dronemap.ws.system;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import java.util.Map;
import org.dronemap.core.process.ProcessCrash;
import org.jspecify.annotations.Nullable;

/**
 * The health of the server and its parts, as everybody may see it.
 *
 * @param status up, or degraded when any part is down
 * @param parts up or down, by name
 * @param lastEnd how the server ended before, if nobody stopped it; null: it was stopped
 * @param setAside it ended so often that it started without its operations
 * @param refusedPeers so many peers, whose messages it was at when it ended, are not heard
 */
@Schema(name = "HealthView")
record HealthView(
        String status,
        String database,
        String links,
        String history,
        String runs,
        Map<String, String> parts,
        @Nullable LastEnd lastEnd,
        boolean setAside,
        int refusedPeers,
        DroneCounts drones,
        String version,
        long uptimeSeconds) {
    /** Numbers of drones by link state (live, suspect, lost), ready to be armed, and armed (in contact or not). */
    @Schema(name = "HealthDroneCounts")
    public record DroneCounts(long live, long suspect, long lost, long ready, long armed) {}

    /**
     * An end that nobody wanted.
     *
     * @param at ms since 1970; the last sign of life
     * @param part what could not go on
     */
    @Schema(name = "HealthLastEnd")
    public record LastEnd(long at, String part) {
        static @Nullable LastEnd of(@Nullable ProcessCrash end) {
            return end == null ? null : new LastEnd(end.at().toEpochMilli(), end.part());
        }
    }

    /**
     * State of each part of the server, for administrators.
     *
     * @param ends how the server ended that made it careful, or at least the last one
     * @param refused peers that are not heard until the server is started again
     */
    @Schema(name = "HealthDetails")
    public record Details(List<Part> parts, List<End> ends, List<String> refused) {}

    /** {@code why}: a sentence; null: it is up. */
    @Schema(name = "HealthPart")
    public record Part(String name, String state, @Nullable String why) {}

    /** {@code at}: ms since 1970. */
    @Schema(name = "HealthEnd")
    public record End(long at, String part, String why, List<String> peers) {
        static End of(ProcessCrash end) {
            return new End(
                    end.at().toEpochMilli(),
                    end.part(),
                    end.why(),
                    end.peers().stream().map(Object::toString).toList());
        }
    }
}
