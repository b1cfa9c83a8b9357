package org.dronemap.ws.outlet;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The state of the outlet for third-party ground stations, with its clients and ports, as clients of the API see it.
 *
 * @param endpoints where it listens
 * @param dropped messages of vehicles that found no room on their way to clients
 * @param notPassed messages of clients of kinds that do not pass
 */
@Schema(name = "OutletView")
public record OutletView(
        List<String> endpoints,
        List<ClientView> clients,
        List<PortView> ports,
        RefusedView refused,
        long dropped,
        long notPassed) {
    /**
     * A ground station or program that is attached.
     *
     * @param systemId its own
     * @param drones how many it is shown
     */
    @Schema(name = "OutletClientView")
    public record ClientView(
            String id,
            String user,
            String address,
            String transport,
            int systemId,
            int drones,
            Instant since,
            long messagesIn,
            long messagesOut,
            double messagesPerSecondIn,
            double messagesPerSecondOut,
            long dropped,
            int queue,
            double silentSeconds) {}

    /**
     * A port of a user's own for a program that cannot sign, at which nothing is ever changed.
     *
     * @param endpoint where it listens
     * @param address from where it may be spoken to
     * @param peer the first that spoke, which has it; null: nobody did
     * @param refused messages from elsewhere
     */
    @Schema(name = "OutletPortView")
    public record PortView(
            String id,
            String user,
            String endpoint,
            String address,
            @Nullable String peer,
            long refused,
            Instant since,
            Instant until) {}

    /**
     * Messages that stayed outside.
     *
     * @param turnedAway signed rightly, by somebody who may not attach
     * @param elsewhere at a personal port, from where it is not bound to
     */
    @Schema(name = "OutletRefusedView")
    public record RefusedView(
            long unsigned, long badSignature, long replayed, long tooOld, long turnedAway, long elsewhere) {}
}
