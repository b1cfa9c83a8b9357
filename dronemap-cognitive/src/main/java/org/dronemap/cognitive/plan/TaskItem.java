package org.dronemap.cognitive.plan;

import org.dronemap.core.stored.Stored;

/** Which item of a mission, from 0, does which part, from 0, of a waypoint's task. */
@Stored(names = "item waypoint part")
public record TaskItem(int item, String waypoint, int part) {}
