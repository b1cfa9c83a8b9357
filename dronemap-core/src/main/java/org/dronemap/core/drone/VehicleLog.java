package org.dronemap.core.drone;

import java.time.Instant;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * An entry of the list of flight logs on board a vehicle.
 *
 * @param number the vehicle's own number for it
 * @param at when it was written; null when the vehicle did not know the time
 */
@Stored(names = "number at sizeBytes")
public record VehicleLog(int number, @Nullable Instant at, long sizeBytes) {}
