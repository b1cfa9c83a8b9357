/**
 * Simulated robots that speak ROSLink, over real sockets or any other links, with the ways of the bridges in the
 * field.
 *
 * <p>Enters: a way of robots in the field.
 *
 * <p>Never: drones.
 */
@NullMarked
package org.dronemap.sim.robot;

import org.jspecify.annotations.NullMarked;
