package org.dronemap.cognitive.plan;

import org.dronemap.core.stored.Stored;

/** A link from a mission item to the part of a waypoint's task that it does. */
@Stored(names = "item waypoint part")
public record TaskItem(int item, String waypoint, int part) {}
