package org.dronemap.core.separation;

import org.dronemap.core.geo.Geodetic;

/** A place where a drone that is not heard may be now; its altitude in metres above mean sea level. */
public record PossiblePlace(Geodetic point, double altitudeAmslMeters) {}
