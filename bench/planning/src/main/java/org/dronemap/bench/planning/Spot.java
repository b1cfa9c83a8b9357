package org.dronemap.bench.planning;

/** A point of the plane, in the problem's unit. */
public record Spot(double x, double y) {}
