/**
 * Missions under way that lose a drone: how soon there is another plan, and how good it is.
 *
 * <p>Enters: what loses drones under way.
 *
 * <p>Never: the planner.
 */
@NullMarked
package org.dronemap.bench.planning.loss;

import org.jspecify.annotations.NullMarked;
