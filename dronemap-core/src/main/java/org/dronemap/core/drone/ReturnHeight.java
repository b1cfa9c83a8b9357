package org.dronemap.core.drone;

import org.dronemap.core.stored.Stored;

/** How high over its home a vehicle flies home since the cloud set that, and what was set before, in m. */
@Stored(names = "meters beforeMeters")
public record ReturnHeight(double meters, double beforeMeters) {}
