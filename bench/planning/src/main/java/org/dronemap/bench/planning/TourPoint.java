package org.dronemap.bench.planning;

/** A point of the plane, in the problem's unit. */
public record TourPoint(double x, double y) {}
