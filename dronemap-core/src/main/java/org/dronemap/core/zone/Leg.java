package org.dronemap.core.zone;

import org.dronemap.core.geo.Geodetic;

/**
 * A straight leg of a predicted route, or a vertical column over one place.
 *
 * @param words what it is, as the beginning of a sentence: "The way from item 2 to item 3"
 */
public record Leg(String words, Geodetic from, Geodetic to, LegHeights heights) {}
