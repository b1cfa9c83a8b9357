package org.dronemap.core.lease;

import java.time.Instant;
import org.dronemap.core.drone.DroneId;

/** Explicit control by a user, as it outlives the process. */
public record SavedLease(DroneId drone, String user, Instant since) {}
