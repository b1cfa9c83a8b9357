package org.dronemap.proxy.outlet;

import java.time.Instant;
import java.util.List;

/**
 * How the outlet is doing at one moment.
 *
 * @param unread frames of vehicles that found no room on their way to the clients
 * @param notPassed frames of clients that are of a kind that does not pass
 */
public record OutletStatus(List<Client> clients, Refused refused, long unread, long notPassed) {
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

    /** Frames of strangers by why they stayed outside; {@code turnedAway}: signed rightly, and yet. */
    public record Refused(long unsigned, long badSignature, long replayed, long tooOld, long turnedAway) {}
}
