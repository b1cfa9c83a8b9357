/** Simulated robots that speak ROSLink over real sockets, with the ways of the bridges in the field. */
@NullMarked
package org.dronemap.sim.robot;

import org.jspecify.annotations.NullMarked;
