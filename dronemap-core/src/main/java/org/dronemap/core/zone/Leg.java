package org.dronemap.core.zone;

import org.dronemap.core.geo.Geodetic;

/**
 * A straight piece of a way, or a column over one place.
 *
 * @param words what it is, as the beginning of a sentence: "The way from item 2 to item 3"
 */
public record Leg(String words, Geodetic from, Geodetic to, Heights heights) {}
