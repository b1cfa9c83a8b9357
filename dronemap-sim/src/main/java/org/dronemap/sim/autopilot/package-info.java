/**
 * How a vehicle talks: orders, missions, parameters and streams in MAVLink, and what differs between autopilots.
 *
 * <p>Enters: what autopilots share on the wire.
 *
 * <p>Never: physics.
 */
@NullMarked
package org.dronemap.sim.autopilot;

import org.jspecify.annotations.NullMarked;
