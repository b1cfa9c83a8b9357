package org.dronemap.cognitive.replan;

import org.dronemap.core.stored.Stored;

/**
 * Figures of a plan before deconfliction: longest tour, sum, cost and unserved waypoints.
 *
 * @param longestSeconds when the last tour ends, on the plan's clock
 * @param sum what the objective sums, in its unit
 * @param cost the objective itself, of what is served
 * @param unserved how many waypoints nobody visits
 */
@Stored(names = "longestSeconds sum cost unserved")
public record PlanFigures(double longestSeconds, double sum, double cost, int unserved) {}
