package org.dronemap.cognitive.plan;

/** A waypoint that nobody visits, and why, as a sentence. */
public record Unserved(String waypoint, String why) {}
