package org.dronemap.cognitive.plan;

import org.dronemap.cognitive.problem.Place;
import org.dronemap.core.stored.Stored;

/** A place with the second of the plan's clock at which a drone is there. */
@Stored(names = "place seconds")
public record TimedPlace(Place place, double seconds) {}
