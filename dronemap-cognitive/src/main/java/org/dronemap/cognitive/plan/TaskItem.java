package org.dronemap.cognitive.plan;

/** Which item of a mission, from 0, does which part, from 0, of a waypoint's task. */
public record TaskItem(int item, String waypoint, int part) {}
