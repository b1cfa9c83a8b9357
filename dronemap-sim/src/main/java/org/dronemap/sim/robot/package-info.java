/** Simulated robots that speak ROSLink, over real sockets or any other links, with the ways of the bridges in the field. */
@NullMarked
package org.dronemap.sim.robot;

import org.jspecify.annotations.NullMarked;
