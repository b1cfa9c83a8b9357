package org.dronemap.cognitive.engine;

/**
 * Figures of the best plan that a search has found so far, such as longest tour, unserved waypoints and gap to the
 * bound.
 *
 * @param longestSeconds when the last tour ends, on the plan's clock, before drones are kept apart
 * @param sum what the objective sums, in its unit
 * @param unserved how many waypoints nobody visits
 * @param gap how far the plan may at most be from the best one, as a share of its own cost: 0 is proved best; 1 while
 *     waypoints are left out, since the bound speaks of whole plans
 * @param iterations how many changes were tried
 */
public record SearchProgress(double longestSeconds, double sum, int unserved, double gap, long iterations) {}
