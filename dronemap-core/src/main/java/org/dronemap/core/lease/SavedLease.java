package org.dronemap.core.lease;

import java.time.Instant;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/**
 * A user's control of a drone as stored over restarts, or that it lapsed and the drone has to be called back.
 *
 * @param since when it began, or lapsed
 * @param epoch that the user knows it by
 * @param mode that the drone flew in by the will of this cloud; null: not known
 */
public record SavedLease(
        DroneId drone,
        String user,
        Instant since,
        long epoch,
        boolean lapsed,
        @Nullable String mode) {
    public SavedLease(DroneId drone, String user, Instant since, long epoch, boolean lapsed) {
        this(drone, user, since, epoch, lapsed, null);
    }
}
