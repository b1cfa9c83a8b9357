package org.dronemap.core.mission;

import org.dronemap.core.stored.Stored;

/**
 * Zero level of a height that a vehicle keeps on board. Unlike {@link Altitude.Reference} it has the ground below, which
 * only the vehicle knows: such a height is kept and shown as it is, never compared with others.
 */
@Stored(names = "HOME AMSL TERRAIN")
public enum HeightReference {
    /** The vehicle's home position. */
    HOME,
    /** Mean sea level. */
    AMSL,
    /** The ground below, as the vehicle's own map of it has it. */
    TERRAIN
}
