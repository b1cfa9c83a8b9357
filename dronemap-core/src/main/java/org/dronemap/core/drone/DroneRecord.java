package org.dronemap.core.drone;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * A drone as stored, so that it is known again after a restart: identity, last address, last heard.
 *
 * @param key the last link session it was heard on
 * @param groundAmslMeters of the ground that it left last; null: not known
 */
public record DroneRecord(
        DroneId id,
        String name,
        DroneKey key,
        String transport,
        Identification identification,
        IdentityTrust standing,
        Instant lastHeard,
        @Nullable Double groundAmslMeters) {
    /** Of a drone that has shown nothing but its address yet. */
    public DroneRecord(
            DroneId id, String name, DroneKey key, String transport, Identification identification, Instant lastHeard) {
        this(id, name, key, transport, identification, IdentityTrust.UNPROVED, lastHeard, null);
    }
}
