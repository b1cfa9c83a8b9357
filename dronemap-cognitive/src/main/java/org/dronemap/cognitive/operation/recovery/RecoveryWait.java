package org.dronemap.cognitive.operation.recovery;

import org.dronemap.core.drone.DroneId;
import org.dronemap.core.stored.Stored;

/**
 * A rule of a recovery: one drone does not begin a step before another one has come so far.
 *
 * @param step of the one that waits
 * @param reached what the other one has begun by then
 */
@Stored(names = "step other reached")
public record RecoveryWait(RecoveryStep step, DroneId other, RecoveryStep reached) {}
