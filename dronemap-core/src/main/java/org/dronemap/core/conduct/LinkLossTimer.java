package org.dronemap.core.conduct;

import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import java.util.function.LongSupplier;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;

/**
 * Measures for how long the links of drones have been lost, for operations and virtual drones. Owned by the conductor's
 * thread.
 */
final class LinkLossTimer {
    private final LongSupplier nanoTime;
    private final Map<DroneId, Long> since = new HashMap<>();

    LinkLossTimer(LongSupplier nanoTime) {
        this.nanoTime = nanoTime;
    }

    /** Zero while its link is not lost. */
    Duration of(DroneState drone) {
        if (drone.link().state() != LinkState.LOST) {
            since.remove(drone.id());
            return Duration.ZERO;
        }
        long now = nanoTime.getAsLong();
        return Duration.ofNanos(now - since.computeIfAbsent(drone.id(), id -> now));
    }
}
