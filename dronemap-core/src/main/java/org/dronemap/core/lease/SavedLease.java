package org.dronemap.core.lease;

import java.time.Instant;
import org.dronemap.core.drone.DroneId;

/**
 * Explicit control by a user, as it outlives the process; or that it lapsed, and the drone has to be called back: so does
 * control that came with a command, which nobody keeps by a sign.
 *
 * @param since when it began, or lapsed
 * @param epoch that the user knows it by
 */
public record SavedLease(DroneId drone, String user, Instant since, long epoch, boolean lapsed) {}
