package org.dronemap.cognitive.plan;

import org.dronemap.core.stored.Stored;

/** A waypoint that nobody visits, and why, as a sentence. */
@Stored(names = "waypoint why")
public record UnservedWaypoint(String waypoint, String why) {}
