package org.dronemap.cognitive.plan;

import org.dronemap.cognitive.problem.Place;
import org.dronemap.core.stored.Stored;

/** Where a drone is at a moment of the plan's clock, in seconds. */
@Stored(names = "place seconds")
public record Fix(Place place, double seconds) {}
