package org.dronemap.cognitive.plan;

import org.dronemap.core.stored.Stored;

/** Tells which item of a planned mission does which part of a waypoint's task. */
@Stored(names = "item waypoint part")
public record TaskItem(int item, String waypoint, int part) {}
