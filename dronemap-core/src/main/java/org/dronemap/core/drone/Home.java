package org.dronemap.core.drone;

import org.dronemap.core.geo.Geodetic;

/** Home position that the vehicle returns to; altitude in metres above mean sea level. */
public record Home(Geodetic point, double altitudeAmslMeters) {}
