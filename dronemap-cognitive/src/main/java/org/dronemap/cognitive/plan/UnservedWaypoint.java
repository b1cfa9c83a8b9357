package org.dronemap.cognitive.plan;

import org.dronemap.core.stored.Stored;

/** A waypoint that a plan leaves out, with the reason as a sentence. */
@Stored(names = "waypoint why")
public record UnservedWaypoint(String waypoint, String why) {}
