package org.dronemap.cognitive.plan;

import org.dronemap.cognitive.problem.Place;
import org.dronemap.core.stored.Stored;

/** A place and the time on the plan's clock, in seconds, at which a drone is there. */
@Stored(names = "place seconds")
public record TimedPlace(Place place, double seconds) {}
