package org.dronemap.core.virtual;

/**
 * What a drone is looked for to do.
 *
 * @param first the tour's waypoint to begin with, counted from 0
 */
public record Demand(Needs needs, Tour tour, int first) {}
