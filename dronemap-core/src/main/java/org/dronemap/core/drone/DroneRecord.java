package org.dronemap.core.drone;

import java.time.Instant;

/**
 * What is remembered of a drone while it is away.
 *
 * @param key the last link session it was heard on
 */
public record DroneRecord(
        DroneId id, String name, DroneKey key, String transport, Identification identification, Instant lastHeard) {}
