package org.dronemap.proxy.outlet.client;

import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * A snapshot of the outlet: attached ground stations, personal ports and refused frames.
 *
 * @param unread frames of vehicles that found no room on their way to the clients
 * @param notPassed frames of clients that are of a kind that does not pass
 */
public record OutletStatus(List<Client> clients, List<Port> ports, Refused refused, long unread, long notPassed) {
    /**
     * A ground station or program that is attached.
     *
     * @param systemId its own, as it said
     * @param drones how many it is shown
     * @param framesPerSecondOut over the last second, as {@code framesPerSecondIn}
     * @param dropped frames for it that newer ones replaced, or that found no room
     * @param silentSeconds since it last said something
     */
    public record Client(
            String id,
            String user,
            String address,
            String transport,
            int systemId,
            int drones,
            Instant since,
            long framesIn,
            long framesOut,
            double framesPerSecondIn,
            double framesPerSecondOut,
            long dropped,
            int waiting,
            double silentSeconds) {}

    /**
     * A personal port.
     *
     * @param endpoint where it listens
     * @param allowed from where it may be spoken to
     * @param peer who has it; null until somebody speaks
     * @param refused frames from elsewhere
     */
    public record Port(
            String id,
            String user,
            String endpoint,
            String allowed,
            @Nullable String peer,
            long refused,
            Instant since,
            Instant until) {}

    /**
     * Frames of strangers by why they stayed outside.
     *
     * @param turnedAway signed rightly, and yet
     * @param elsewhere at a personal port, from where it is not bound to
     */
    public record Refused(
            long unsigned, long badSignature, long replayed, long tooOld, long turnedAway, long elsewhere) {}
}
