package org.dronemap.core.drone;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * The link that a drone is reached by; {@code lastHeard} is null until something was heard since the start.
 *
 * @param quality unknown while the drone is lost
 */
public record LinkStatus(
        DroneKey key,
        String transport,
        LinkState state,
        @Nullable Instant lastHeard,
        LinkQuality quality) {}
