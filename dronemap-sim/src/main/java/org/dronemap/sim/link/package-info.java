/**
 * Sockets of a whole fleet on one thread, and the clock that drives it.
 *
 * <p>Enters: how a fleet's bytes get out and in.
 *
 * <p>Never: vehicles.
 */
@NullMarked
package org.dronemap.sim.link;

import org.jspecify.annotations.NullMarked;
