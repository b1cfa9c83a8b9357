/** Simulated vehicles: a stand-in for ArduPilot and PX4 that speaks real MAVLink. */
@NullMarked
package org.dronemap.sim;

import org.jspecify.annotations.NullMarked;
