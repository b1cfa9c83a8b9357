package org.dronemap.core.conduct;

import java.util.Optional;
import org.dronemap.core.virtual.UnfitReason;
import org.dronemap.core.virtual.VirtualDrone;
import org.dronemap.core.virtual.VirtualRun;

/**
 * A virtual drone that waits for a drone, with whether a certain real drone could serve it.
 *
 * @param share what that one would fly of it
 * @param whyNot why it could not; empty: it would be sent to fly it
 */
public record VirtualDroneMatch(VirtualDrone waiting, VirtualRun share, Optional<UnfitReason> whyNot) {}
