package org.dronemap.core.drone;

import org.dronemap.core.stored.Stored;

/** Return height over home that the cloud has set, and the one set before it, in metres. */
@Stored(names = "meters beforeMeters")
public record ReturnHeight(double meters, double beforeMeters) {}
