package org.dronemap.core.drone;

import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The link that a drone is reached by; {@code lastHeard} is null until something was heard since the start.
 *
 * @param quality unknown while the drone is lost
 * @param others further links that the same vehicle is heard on
 */
public record LinkStatus(
        DroneKey key,
        String transport,
        LinkState state,
        @Nullable Instant lastHeard,
        LinkQuality quality,
        List<DroneKey> others) {}
