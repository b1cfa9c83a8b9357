package org.dronemap.ws.service;

import java.time.Instant;
import java.util.List;

/**
 * The outlet at one moment.
 *
 * @param endpoints where it listens
 * @param dropped messages of vehicles that found no room on their way to clients
 * @param notPassed messages of clients of kinds that do not pass
 */
public record OutletView(
        List<String> endpoints, List<ClientView> clients, RefusedView refused, long dropped, long notPassed) {
    /**
     * A ground station or program that is attached.
     *
     * @param systemId its own
     * @param drones how many it is shown
     */
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

    /** Messages that stayed outside; {@code turnedAway}: signed rightly, by somebody who may not attach. */
    public record RefusedView(long unsigned, long badSignature, long replayed, long tooOld, long turnedAway) {}
}
