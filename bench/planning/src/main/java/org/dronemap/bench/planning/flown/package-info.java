/**
 * Plans flown by simulated vehicles: how well their times and energies were foretold.
 *
 * <p>Enters: what flies plans in the simulator.
 *
 * <p>Never: the planner.
 */
@NullMarked
package org.dronemap.bench.planning.flown;

import org.jspecify.annotations.NullMarked;
