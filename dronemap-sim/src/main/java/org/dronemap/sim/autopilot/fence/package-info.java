/**
 * The fence that an ArduPilot vehicle carries: what it stores of one, and when it is outside.
 *
 * <p>Enters: shapes, bounds and breaches as ArduPilot counts them.
 *
 * <p>Never: what a vehicle does after a breach.
 */
@NullMarked
package org.dronemap.sim.autopilot.fence;

import org.jspecify.annotations.NullMarked;
