/**
 * How a multicopter moves, is blown about and runs out of energy: pure state, stepped by its owner, metres and
 * seconds.
 *
 * <p>Enters: a force, a sensor or a battery.
 *
 * <p>Never: autopilots.
 */
@NullMarked
package org.dronemap.sim.physics;

import org.jspecify.annotations.NullMarked;
