package org.dronemap.core.conduct;

import java.util.Optional;
import org.dronemap.core.virtual.UnfitReason;
import org.dronemap.core.virtual.VirtualDrone;

/**
 * A virtual drone that waits for a drone, with whether a certain real drone could serve it.
 *
 * @param whyNot why it could not; empty: it would be sent to fly it
 */
public record VirtualDroneMatch(VirtualDrone waiting, Optional<UnfitReason> whyNot) {}
