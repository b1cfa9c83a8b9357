package org.dronemap.core.safety;

import org.dronemap.core.geo.Geodetic;

/**
 * A place that is known to be fit for a landing.
 *
 * @param words what people call it: "a rally point"
 */
public record LandingSite(Geodetic point, String words) {}
