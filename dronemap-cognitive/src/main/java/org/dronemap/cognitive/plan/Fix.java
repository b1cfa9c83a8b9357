package org.dronemap.cognitive.plan;

import org.dronemap.cognitive.problem.Place;

/** Where a drone is at a moment of the plan's clock, in seconds. */
public record Fix(Place place, double seconds) {}
