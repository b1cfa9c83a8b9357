/** Sockets of a whole fleet on one thread, and the clock that drives it. */
@NullMarked
package org.dronemap.sim.link;

import org.jspecify.annotations.NullMarked;
