package org.dronemap.core.operation;

import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.stored.Stored;

/**
 * A drone of the pool that was chosen for an operation, with the reason.
 *
 * @param name as people call it
 * @param home where it flies back to
 * @param why it was chosen, as one or more sentences
 */
@Stored(names = "drone name home homeAmslMeters why")
public record ChosenDrone(DroneId drone, String name, Geodetic home, double homeAmslMeters, String why) {}
