package org.dronemap.core.cloud;

import java.time.Instant;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.Identification;
import org.jspecify.annotations.Nullable;

/**
 * A connected vehicle that is not admitted yet; it is sent nothing but a request for its identity.
 *
 * @param claims the drone that it says it is, without showing it; null for one that nobody knows
 */
public record WaitingVehicle(
        String id,
        DroneKey key,
        String transport,
        Identification identification,
        @Nullable DroneId claims,
        String why,
        Instant since,
        Instant lastHeard) {
    /** It says that it is a drone which it is not, as far as anybody can tell. */
    public boolean isQuarantined() {
        return claims != null;
    }
}
