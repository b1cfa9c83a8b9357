package org.dronemap.core.drone;

/** How high over its home a vehicle flies home since the cloud set that, and what was set before, in m. */
public record ReturnHeight(double meters, double beforeMeters) {}
