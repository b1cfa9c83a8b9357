package org.dronemap.core.safety;

import org.dronemap.core.geo.Geodetic;

/**
 * A place known to be fit for landing, such as home or a rally point, with words for it.
 *
 * @param words what people call it: "a rally point"
 */
public record LandingSite(Geodetic point, String words) {}
