package org.dronemap.core.lease;

import java.time.Instant;
import org.dronemap.core.drone.DroneId;

/** Explicit control by a user, as it outlives the process; the epoch is the one that the user knows it by. */
public record SavedLease(DroneId drone, String user, Instant since, long epoch) {}
