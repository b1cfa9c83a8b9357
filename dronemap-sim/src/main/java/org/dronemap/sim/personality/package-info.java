/** How a vehicle talks: orders, missions, parameters and streams in MAVLink, and what differs between autopilots. */
@NullMarked
package org.dronemap.sim.personality;

import org.jspecify.annotations.NullMarked;
