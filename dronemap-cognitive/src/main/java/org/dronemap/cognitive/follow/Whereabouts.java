package org.dronemap.cognitive.follow;

import java.time.Instant;
import org.dronemap.core.geo.Geodetic;

/**
 * Where a drone said that it is, and how it moves, in m/s.
 *
 * @param at when it was there
 */
public record Whereabouts(Instant at, Geodetic point, double altitudeAmslMeters, double eastward, double northward) {}
